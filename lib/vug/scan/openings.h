// Windows and doors in a scanned facade without a grammar: what no return came from and what is
// set back behind the wall, as rectangles (section 3 of [@ripperda2009]).
#pragma once

#include <vug/scan/surfaces.h>

#include <string>
#include <vector>

namespace vug::scan {

enum class OpeningKind { window, door };
std::string to_string(OpeningKind kind);

/// A box on the plane of a range image: metres from its lower left corner, x to the right, y up.
using Box = Imath::Box2d;

struct Opening {
  OpeningKind kind = OpeningKind::window;  ///< A door stands on the ground.
  Box box;
  double empty = 0;     ///< Part of its pixels from which nothing came back.
  double set_back = 0;  ///< Metres behind the wall, the median of the others; may be NaN.
};

struct OpeningOptions {
  double closing = 0.12;       ///< Metres; gaps in the wall up to this wide are none.
  double min_size = 0.5;       ///< Metres that an opening is wide and high, at least
  double max_size = 6;         ///< and at most.
  double door_sill = 0.5;      ///< Metres above the ground up to which doors begin.
  double min_perimeter = 2.5;  ///< Perimeter from which a triangle spans an opening, in those of
                               ///< the triangles between neighbouring points.
  /// False: as in the paper. True: openings are tidied up. Bars of the raster are passed over,
  /// groups taken apart where that is sparing (split.h), at necks if they are too large else, and
  /// where one part shows things behind the wall and the other nothing at all.
  bool tidy = true;
  double max_bar_width = 0.2;   ///< Metres; wall within openings that is no wider is none.
  double max_neck_width = 0.3;  ///< Metres; openings that hang together by no more are several.
  uint64_t memory = available_memory();  ///< Bytes that the search may take.
};

/// By raster, from the ground up: pixels without a point of the wall, gaps closed, connected, and
/// sifted by size. Error(bad_input) for options out of range.
std::vector<Opening> openings_by_raster(const RangeImage& range, const SurfaceMap& map,
                                        const OpeningOptions& options = {});

/// By triangles, in the same order: those of the Delaunay triangulation of the wall's points whose
/// perimeter is long
/// [@pu2007], connected, and sifted by size.
std::vector<Opening> openings_by_triangles(const PointCloud& cloud, const RangeImage& range,
                                           const SurfaceMap& map,
                                           const OpeningOptions& options = {});

}  // namespace vug::scan
