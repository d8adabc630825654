// Points as a scanner gives them.
#pragma once

#include <vug/base/vec.h>

#include <vector>

namespace vug::scan {

/// Positions are in metres, in the file's own axes, and finite: double keeps millimetres of
/// coordinates that count from the equator. The other lists are empty or have one item a point, and
/// may hold NaN.
struct PointCloud {
  std::vector<Vec3d> positions;
  std::vector<Vec3f> colours;      ///< As stored, mostly sRGB, 0..1.
  std::vector<float> intensities;  ///< In the scanner's own units.
  std::vector<Vec3f> normals;      ///< Of any length.
  size_t dropped = 0;              ///< Points of the files whose position was not finite.

  size_t size() const { return positions.size(); }
};

/// Both clouds one after the other; of what only one of them has nothing is left.
PointCloud concatenated(PointCloud a, const PointCloud& b);

}  // namespace vug::scan
