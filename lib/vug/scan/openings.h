// SPDX-License-Identifier: Apache-2.0
// Detection of windows and doors in a scanned facade without a grammar: rectangles without returns
// or set back behind the wall (section 3 of [@ripperda2009]).
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
  OpeningKind kind = OpeningKind::window;  ///< Openings that reach the ground are doors.
  Box box;
  double empty = 0;  ///< Share of its pixels without a return.
  /// Median distance of the other pixels behind the wall, metres; may be NaN.
  double set_back = 0;
};

struct OpeningOptions {
  double closing = 0.12;  ///< Metres; gaps in the wall up to this width are closed.
  double min_size = 0.5;  ///< Minimum width and height of an opening, metres.
  double max_size = 6;    ///< Maximum width and height, metres.
  /// Openings that start at most this far above the ground are doors, metres.
  double door_sill = 0.5;
  /// Minimum perimeter of triangles over openings, relative to the median perimeter of all
  /// triangles.
  double min_perimeter = 2.5;
  /// False: as in the paper. True: bars are ignored, and components are split if that saves area
  /// (split.h), at necks if they are too large, and between parts of which one shows surfaces
  /// behind the wall and the other shows nothing.
  bool tidy = true;
  double max_bar_width = 0.2;  ///< Metres; wall inside an opening up to this width is ignored.
  /// Metres; openings connected by necks up to this width are separated.
  double max_neck_width = 0.3;
  uint64_t memory = available_memory();  ///< Memory limit of the search in bytes.
};

/// Detection on the raster, sorted from the ground up: pixels without points of the wall, closed,
/// grouped into components and filtered by size. Error(bad_input) for options out of range.
std::vector<Opening> openings_by_raster(const RangeImage& range, const SurfaceMap& map,
                                        const OpeningOptions& options = {});

/// Detection with triangles, in the same order: triangles of the Delaunay triangulation of the
/// wall's points with a long perimeter [@pu2007], grouped into components and filtered by size.
std::vector<Opening> openings_by_triangles(const PointCloud& cloud, const RangeImage& range,
                                           const SurfaceMap& map,
                                           const OpeningOptions& options = {});

}  // namespace vug::scan
