// Deformed solids near and far: what twist, taper and bend share.
#pragma once

#include <vug/field/deformer.h>

namespace vug::field {

/// `field` met with the distance to a box that holds its solid: the same surface, but values that
/// go on growing far away, and pruning that drops the field there.
Field enclosed(const Field& field, const Box3d& box);

/// A round hull about the y axis: its radius goes from `low` at y = `from` to `high` at y = `to`,
/// and stays beyond. Maps that draw far points onto it say nothing about them; it does.
struct HullOfRevolution {
  double low = 1, high = 1, from = 0, to = 1;
};
Field within_hull(const Field& field, const HullOfRevolution& hull);

/// `build(child)` deforms along `from` (a unit axis); the result does so along `axis` instead, by
/// turning the child there and back.
template <class Build>
Field along_axis(const Field& child, const Vec3d& from, const Vec3d& axis, const Build& build);

/// The distance that the box's points have at most from the y axis.
double radius_about_y(const Box3d& box);

/// Traits of a deformed child whose map stretches by at most 1 / scale; its box is known only to
/// the caller, who puts it around with enclosed().
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
