// SPDX-License-Identifier: Apache-2.0
#include <vug/base/vec.h>

#include <algorithm>
#include <cmath>

namespace vug {

bool is_finite(const Box3d& box) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!std::isfinite(box.min[axis]) || !std::isfinite(box.max[axis])) return false;
    if (box.min[axis] > box.max[axis]) return false;
  }
  return true;
}

Box3d grown(const Box3d& box, double amount) {
  if (box.isEmpty()) return box;
  return {box.min - Vec3d(amount), box.max + Vec3d(amount)};
}

Box3d intersection(const Box3d& a, const Box3d& b) {
  Box3d common;
  for (int axis = 0; axis < 3; ++axis) {
    common.min[axis] = std::max(a.min[axis], b.min[axis]);
    common.max[axis] = std::min(a.max[axis], b.max[axis]);
    if (common.min[axis] > common.max[axis]) return {};
  }
  return common;
}

Box3d united(const Box3d& a, const Box3d& b) {
  Box3d both = a;
  both.extendBy(b);
  return both;
}

}  // namespace vug
