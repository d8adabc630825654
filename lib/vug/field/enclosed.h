// SPDX-License-Identifier: Apache-2.0
// Intersects a deformed solid with a box or hull that its deformer (twist, taper, bend) has
// computed.
#pragma once

#include <vug/field/deformer.h>

namespace vug::field {

/// Combines `field` with the distance to a box that contains its solid. The surface is unchanged,
/// but values continue to grow far away, and pruning can drop the field there.
Field enclosed(const Field& field, const Box3d& box);

/// A hull of revolution about the y axis: its radius changes from `low` at y = `from` to `high` at
/// y = `to` and is constant beyond. It provides distances where the map compresses far points and
/// the deformed field has no information.
struct HullOfRevolution {
  double low = 1, high = 1, from = 0, to = 1;
};
Field within_hull(const Field& field, const HullOfRevolution& hull);

/// Applies `build(child)`, which deforms along `from` (a unit axis), along `axis` instead, by
/// rotating the child to the axis and back.
template <class Build>
Field along_axis(const Field& child, const Vec3d& from, const Vec3d& axis, const Build& build);

/// The maximum distance of the box's points from the y axis.
double radius_about_y(const Box3d& box);

/// Traits of a deformed child whose map stretches by at most 1 / scale. Only the caller knows its
/// box and adds it with enclosed().
inline Traits deformed_traits(const Traits& child) {
  return {child.lipschitz, std::max(child.exactness, Exactness::bound), infinite_box(), 0};
}

}  // namespace vug::field

#include <vug/base/transform.h>
#include <vug/field/affine.h>

namespace vug::field {

template <class Build>
Field along_axis(const Field& child, const Vec3d& from, const Vec3d& axis, const Build& build) {
  const Vec3d to = axis.normalized();
  if ((to - from).length() < 1e-12) return build(child);
  const Transform turn = rotation_between(from, to);
  return transformed(build(transformed(child, turn.inverse())), turn);
}

}  // namespace vug::field
