// SPDX-License-Identifier: Apache-2.0
// The ball of a box of intervals, in which nodes without interval arithmetic bound their values.
#pragma once

#include <vug/field/node.h>

namespace vug::field {

/// The smallest ball around the region.
inline Ball enclosing_ball(const Point<Interval>& region) {
  const Vec3d size(region.x.width(), region.y.width(), region.z.width());
  return {{region.x.middle(), region.y.middle(), region.z.middle()}, 0.5 * size.length()};
}

}  // namespace vug::field
