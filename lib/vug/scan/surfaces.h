// What each pixel of a scanned facade shows: wall, something set back behind it, or nothing.
#pragma once

#include <vug/scan/wall.h>

#include <vector>

namespace vug::scan {

enum class Surface : uint8_t {
  outside,  ///< Not the facade.
  wall,     ///< Or something before it.
  behind,   ///< Farther back than the wall: a pane, a leaf, a reveal.
  nothing,  ///< No return: glass, a deep room, or something that stood before the wall.
};

struct SurfaceOptions {
  bool bent = true;  ///< The wall has a surface of its own; false: it is the plane.
  /// Metres behind the wall from which points are behind it; below 0: three times the rms of the
  /// wall about its surface, 3 cm at least, and 5 cm behind a plane.
  double set_back = -1;
  double hull = 0.5;  ///< Metres; through wider gaps at its rim the facade is open to outside.
  WallOptions wall = {};
};

struct SurfaceMap {
  Wall wall;
  double set_back = 0;           ///< Metres, as used.
  std::vector<Surface> surface;  ///< One a pixel, row 0 the top row.
};

/// Outside is what can be reached from the left, the right and the upper border of the image
/// without passing depths or gaps narrower than `hull`; doors that are open below so stay inside.
/// Error(bad_input) for options out of range or an image without depths.
SurfaceMap surface_map(const RangeImage& range, const SurfaceOptions& options = {});

}  // namespace vug::scan
