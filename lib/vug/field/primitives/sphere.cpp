// SPDX-License-Identifier: Apache-2.0
// |p| - r: the distance to a ball centred at the origin.
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct Sphere {
  double radius = 1;

  static void describe(Schema<Sphere>& s) {
    s.doc("A ball centred at the origin.")
        .param("radius", &Sphere::radius, positive_length("radius of the ball"));
  }
  template <class T>
  T distance(const Point<T>& p) const {
    return length(p) - T(radius);
  }
  Box3d bounds() const { return {Vec3d(-radius), Vec3d(radius)}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(sphere) { return primitive_kind<Sphere>("sphere"); }
