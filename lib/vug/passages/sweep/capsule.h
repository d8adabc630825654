// SPDX-License-Identifier: Apache-2.0
// The axis of a segment of a passage, with a bound of its values. Searches read capsules
// from a dense array, because a segment has several cache lines.
#pragma once

#include <vug/base/vec.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {

struct Capsule {
  Vec3d start{0.0}, along{1, 0, 0};  ///< The axis starts here; its direction, a unit vector.
  double length = 0;
  double reach = 0;  ///< Radius around the axis that contains the inside.
  double scale = 1;  ///< Least slope of the bound outside.

  /// A point's offset from the nearest point of the axis.
  Vec3d offset(const Vec3d& p) const {
    const Vec3d from = p - start;
    return from - along * std::clamp(from.dot(along), 0.0, length);
  }
  /// A lower bound of the values at this distance from the axis; see SectionTraits::reach.
  double least_at(double distance) const {
    const double away = distance - reach;
    return away > 0 ? scale * away : away;
  }
  double least(const Vec3d& p) const { return least_at(offset(p).length()); }
};

}  // namespace vug::passages
