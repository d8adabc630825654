// SPDX-License-Identifier: Apache-2.0
// Point clouds from laser scanners.
#pragma once

#include <vug/base/vec.h>

#include <vector>

namespace vug::scan {

/// Positions are finite, in metres in the axes of the file; double precision keeps millimetres in
/// geodetic coordinates. The other lists are empty or have one entry per point, and may contain
/// NaN.
struct PointCloud {
  std::vector<Vec3d> positions;
  std::vector<Vec3f> colours;      ///< As stored, mostly sRGB, 0..1.
  std::vector<float> intensities;  ///< In the scanner's own units.
  std::vector<Vec3f> normals;      ///< Any length.
  size_t dropped = 0;              ///< Number of points dropped for a non-finite position.

  size_t size() const { return positions.size(); }
};

/// Appends `b` to `a`; attributes that only one of them has are dropped.
PointCloud concatenated(PointCloud a, const PointCloud& b);

}  // namespace vug::scan
