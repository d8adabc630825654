// SPDX-License-Identifier: Apache-2.0
// Internal to terrain/: heights of a file on a grid along the axes of survey space.
#pragma once

#include <vug/field/heightmap.h>
#include <vug/terrain/elevation_file.h>

#include <functional>
#include <vector>

namespace vug::terrain {

/// Row 0 is the northernmost; the box contains the outermost samples, in the coordinate system of
/// the survey. NaN where the file has no data.
struct PlacedHeights {
  Box3d box{};
  double cell = 0;  ///< The larger distance of neighbouring samples.
  int columns = 0, rows = 0;
  std::vector<float> heights{};
};

/// Maps places between the systems of the file and of the survey (z is 0).
struct Mapping {
  std::function<Vec3d(const Vec3d&)> to_survey, to_file;
  bool identity = false;
};

/// The cells of the file at a box of the survey's plane, and on each side `beyond` times the number
/// of cells in the box; no columns or rows where the file does not reach.
Window cells_at(const ElevationFile& file, const Mapping& mapping, const Box3d& box,
                double beyond = 0);

/// The part of the survey's plane that the centres of these cells enclose: a box inside of it,
/// which is empty for a grid that is rotated too far, and the box around it.
struct Coverage {
  Box3d inside, around;
};
Coverage coverage(const ElevationFile& file, const Mapping& mapping, const Window& cells);

/// The heights in a box of the survey's plane. The box is enlarged to whole cells if the axes
/// agree. Throws Error(bad_input) if the box has no cells, Error(too_large) as
/// ElevationFile::heights.
PlacedHeights place_heights(const ElevationFile& file, const Mapping& mapping, const Box3d& box,
                            field::Sampling sampling);

}  // namespace vug::terrain
