// SPDX-License-Identifier: Apache-2.0
// Classification of the pixels of a scanned facade: wall, set back behind the wall, or without a
// return.
#pragma once

#include <vug/scan/sections.h>
#include <vug/scan/wall.h>

#include <vector>

namespace vug::scan {

enum class Surface : uint8_t {
  outside,  ///< Not part of the facade.
  wall,     ///< Wall, or an object in front of it.
  behind,   ///< Further back than the wall: a pane, a door leaf, a reveal.
  nothing,  ///< No return: glass, a deep room, or the shadow of an object in front of the wall.
};

struct SurfaceOptions {
  bool bent = true;  ///< Each wall is a fitted curved surface; false: the plane.
  /// Distance behind the wall, in metres, beyond which points count as behind it; below 0: three
  /// times the rms of the wall about its surface, at least 3 cm, and 5 cm behind a plane.
  double set_back = -1;
  double hull = 0.5;  ///< Metres; gaps in the rim wider than this connect to the outside.
  WallOptions wall = {};
  SectionOptions sections = {};
};

struct SurfaceMap {
  std::vector<Wall> walls;       ///< The walls at different depths, the largest first.
  Sections sections;             ///< Which of the walls each pixel belongs to.
  double set_back = 0;           ///< The distance that was used, metres.
  std::vector<Surface> surface;  ///< One per pixel; row 0 is the top row.

  /// The wall around a pixel.
  const Wall& wall(size_t pixel) const {
    return walls[sections.of_pixel.empty() ? 0 : sections.of_pixel[pixel]];
  }
};

/// The outside is the region reachable from the left, right and upper border of the image without
/// crossing depths or gaps narrower than `hull`, so doors that are open at the bottom stay inside.
/// Error(bad_input) for options out of range or an image without depths.
SurfaceMap surface_map(const RangeImage& range, const SurfaceOptions& options = {});

}  // namespace vug::scan
