// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/deformer.h>
#include <vug/sgm/connection.h>

#include <algorithm>
#include <memory>

namespace vug::sgm {
namespace {

using field::max;  // For all number types, including double.
using field::min;

/// Collapses the middle part along x to the plane x = 0. The map does not increase distances, so
/// the child's values remain bounds.
struct Elongation {
  double half;  ///< Half of the length of the middle part, metres.

  template <class T>
  field::Point<T> map(const field::Point<T>& p) const {
    // Monotonic terms, so that intervals stay narrow; equal to x - clamp(x, -half, half).
    return {max(p.x - T(half), T(0.0)) + min(p.x + T(half), T(0.0)), p.y, p.z};
  }
  field::Ball map(const field::Ball& ball) const {
    return {field::vector(map(field::point(ball.centre))), ball.radius};
  }
  double scale() const { return 1; }
  field::Traits traits(const field::Traits& child) const {
    field::Traits out = child;
    out.growth = child.growth_rate();
    out.exactness = std::max(child.exactness, field::Exactness::bound);
    out.bounds.min.x -= half;
    out.bounds.max.x += half;
    return out;
  }
};

}  // namespace

field::Field elongated(const field::Field& field, double length) {
  const field::Field centred =
      field::transformed(field, Transform::translation(-field.bounds().center()));
  return field::Field(std::make_shared<field::DeformerNode<Elongation>>(
      "elongate", Elongation{0.5 * length}, centred.node()));
}

Transform frame_between(const Vec3d& a, const Vec3d& b) {
  const Vec3d x = (b - a).normalized(), side = x.cross({0, 1, 0});
  const Vec3d z = side.length() > 1e-9 ? side.normalized() : Vec3d(0, 0, 1);
  return {x, z.cross(x), z, 0.5 * (a + b)};
}

}  // namespace vug::sgm
