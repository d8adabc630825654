// SPDX-License-Identifier: Apache-2.0
// The exact distance to the convex hull of two balls (a "round cone", quilez2008distance). The
// nearest surface point lies on the normal through p; the normals of the slanted part leave the
// axis at a fixed slope, so the projection of p onto the axis along that slope decides which of
// three parts is nearest.
#pragma once

#include <vug/field/node.h>

#include <cmath>

namespace vug::field {

/// Neither ball may lie inside the other; see round_cone_nests.
struct RoundCone {
  Vec3d a, b;
  double radius_a, radius_b;
  double length_ab = (b - a).length();
  Vec3d axis = (b - a) / length_ab;
  double sine = (radius_a - radius_b) / length_ab;
  double cosine = std::sqrt(1 - sine * sine);

  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> from_a = p - constant<T>(a);
    const T y = dot(from_a, constant<T>(axis));
    const T x = length(from_a - constant<T>(axis) * y);
    const T foot = y - x * T(sine / cosine);
    const T at_b = length(x, y - T(length_ab)) - T(radius_b);
    const T slant = x * T(cosine) + y * T(sine) - T(radius_a);
    return select(foot < T(0.0), length(x, y) - T(radius_a),
                  select(foot > T(length_ab), at_b, slant));
  }
  Box3d bounds() const { return united(grown(Box3d(a), radius_a), grown(Box3d(b), radius_b)); }
  RoundCone translated(const Vec3d& by) const { return {a + by, b + by, radius_a, radius_b}; }
  /// The smallest ball around it.
  Ball ball() const {
    const double radius = 0.5 * (length_ab + radius_a + radius_b);
    return {a + axis * (radius - radius_a), radius};
  }
};

/// True if one ball lies inside the other.
inline bool round_cone_nests(const Vec3d& a, const Vec3d& b, double radius_a, double radius_b) {
  return std::fabs(radius_a - radius_b) >= (b - a).length();
}

}  // namespace vug::field
