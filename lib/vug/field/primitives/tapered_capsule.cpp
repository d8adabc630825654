// SPDX-License-Identifier: Apache-2.0
// The exact distance to the convex hull of two balls (a "round cone", quilez2008distance). The
// nearest surface point lies on the normal through p; the normals of the slanted part leave the
// axis at a fixed slope, so the projection of p onto the axis along that slope decides which of
// three parts is nearest.
#include <vug/field/primitive.h>

#include <algorithm>

namespace vug::field {
namespace {

struct TaperedCapsuleShape {
  Vec3d a, axis;
  double length_ab, radius_a, radius_b;
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
  Box3d bounds() const {
    const Vec3d b = a + axis * length_ab;
    return united(grown(Box3d(a), radius_a), grown(Box3d(b), radius_b));
  }
};

struct TaperedCapsule {
  Vec3d a{0, -0.5, 0};
  Vec3d b{0, 0.5, 0};
  double radius_a = 0.5;
  double radius_b = 0.25;

  static void describe(Schema<TaperedCapsule>& s) {
    s.doc("Two balls and the region between them: a rod with round ends of two sizes.")
        .cite("quilez2008distance")
        .param("a", &TaperedCapsule::a, any_length("centre of the first ball"))
        .param("b", &TaperedCapsule::b, any_length("centre of the second ball"))
        .param("radius_a", &TaperedCapsule::radius_a, positive_length("radius of the first ball"))
        .param("radius_b", &TaperedCapsule::radius_b, positive_length("radius of the second ball"));
  }
  std::string fault() const {
    return std::fabs(radius_a - radius_b) >= (b - a).length()
               ? "one ball of a tapered capsule lies inside the other; increase the distance of "
                 "their centres"
               : "";
  }
  TaperedCapsuleShape shape() const {
    const double far = (b - a).length();
    return {a, (b - a) / far, far, radius_a, radius_b};
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(tapered_capsule) { return primitive_kind<TaperedCapsule>("tapered_capsule"); }
