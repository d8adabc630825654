// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/passages/breakdown/oriented_box.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

/// Calls visit(axis, reach) for the 15 axes that can separate two boxes; `reach` is the sum of the
/// boxes' half extents. Stops when it returns false.
template <class Visit>
void for_each_axis(const OrientedBox& a, const OrientedBox& b, const Visit& visit) {
  const auto go_on = [&](const Vec3d& axis) {
    return visit(axis, a.extent(axis) + b.extent(axis));
  };
  for (const Vec3d& axis : a.axes)
    if (!go_on(axis)) return;
  for (const Vec3d& axis : b.axes)
    if (!go_on(axis)) return;
  for (const Vec3d& u : a.axes)
    for (const Vec3d& v : b.axes) {
      const Vec3d axis = u.cross(v);
      // Edges that are parallel have no axis of their own.
      if (axis.length() > 1e-6 && !go_on(axis.normalized())) return;
    }
}

}  // namespace

double OrientedBox::extent(const Vec3d& direction) const {
  return half.x * std::fabs(axes[0].dot(direction)) + half.y * std::fabs(axes[1].dot(direction)) +
         half.z * std::fabs(axes[2].dot(direction));
}

Box3d OrientedBox::bounds() const {
  const Vec3d reach(extent({1, 0, 0}), extent({0, 1, 0}), extent({0, 0, 1}));
  return {centre - reach, centre + reach};
}

Polytope OrientedBox::polytope() const {
  Polytope out{{}, bounds()};
  for (int i = 0; i < 3; ++i)
    for (const double side : {-1.0, 1.0})
      out.faces.push_back({axes[static_cast<size_t>(i)] * side,
                           side * axes[static_cast<size_t>(i)].dot(centre) + half[i]});
  return out;
}

OrientedBox OrientedBox::turned(const Vec3d& axis, double angle) const {
  const double c = maths::cos(angle), s = maths::sin(angle);
  OrientedBox out = *this;
  for (Vec3d& v : out.axes)
    v = (v * c + axis.cross(v) * s + axis * (axis.dot(v) * (1 - c))).normalized();
  return out;
}

double landing_height(const OrientedBox& falling, const OrientedBox& other) {
  double least = -kInfinity, most = kInfinity;
  const Vec3d offset = falling.centre - other.centre;
  for_each_axis(falling, other, [&](const Vec3d& axis, double reach) {
    // |axis . (offset + (0, t, 0))| < reach holds for t in an interval.
    const double at = axis.dot(offset);
    if (std::fabs(axis.y) < 1e-9) {
      if (std::fabs(at) >= reach) least = kInfinity;
    } else {
      const double one = (-reach - at) / axis.y, two = (reach - at) / axis.y;
      least = std::max(least, std::min(one, two));
      most = std::min(most, std::max(one, two));
    }
    return least < most;
  });
  return least < most ? falling.centre.y + most : -kInfinity;
}

double overlap_depth(const OrientedBox& a, const OrientedBox& b) {
  double depth = kInfinity;
  for_each_axis(a, b, [&](const Vec3d& axis, double reach) {
    depth = std::min(depth, reach - std::fabs(axis.dot(a.centre - b.centre)));
    return true;
  });
  return depth;
}

}  // namespace vug::passages
