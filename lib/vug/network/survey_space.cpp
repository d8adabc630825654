// SPDX-License-Identifier: Apache-2.0
#include <vug/network/survey_space.h>

#include <cmath>

namespace vug::network {

Vec3d rounded_middle(const std::vector<Vec3d>& points) {
  if (points.empty()) return Vec3d(0.0);
  Box3d box;
  for (const Vec3d& point : points) box.extendBy(point);
  // Halves first, so that the sum does not overflow.
  const Vec3d middle = box.min * 0.5 + box.max * 0.5;
  return {std::round(middle.x), std::round(middle.y), std::round(middle.z)};
}

}  // namespace vug::network
