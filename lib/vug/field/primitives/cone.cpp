// SPDX-License-Identifier: Apache-2.0
// The exact distance to a cone: a triangle rotated about the y axis (quilez2008distance).
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

namespace vug::field {
namespace {

struct ConeShape {
  double radius, height;
  Trapezoid profile{radius, 0, 0.5 * height};

  template <class T>
  T distance(const Point<T>& p) const {
    return profile.distance(length(p.x, p.z), p.y);
  }
  Box3d bounds() const {
    const Vec3d half(radius, 0.5 * height, radius);
    return {-half, half};
  }
};

struct Cone {
  double radius = 0.5;
  double height = 1;

  static void describe(Schema<Cone>& s) {
    s.doc("A cone about the y axis with its tip up and the origin halfway between base and tip.")
        .cite("quilez2008distance")
        .param("radius", &Cone::radius, positive_length("radius of the base"))
        .param("height", &Cone::height, positive_length("height from the base to the tip"));
  }
  ConeShape shape() const { return {radius, height}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(cone) { return primitive_kind<Cone>("cone"); }
