// SPDX-License-Identifier: Apache-2.0
// The exact distance to a cylinder: a rectangle rotated about the y axis (quilez2008distance).
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Cylinder {
  double radius = 0.5;
  double height = 1;
  double rounding = 0;

  static void describe(Schema<Cylinder>& s) {
    s.doc("A cylinder about the y axis, centred at the origin.")
        .cite("quilez2008distance")
        .param("radius", &Cylinder::radius, positive_length("radius of the cylinder"))
        .param("height", &Cylinder::height, positive_length("height from end to end along y"))
        .param("rounding", &Cylinder::rounding,
               {.doc = "radius of the two rims, at most the radius and half the height",
                .dimension = Dimension::length,
                .min = 0});
  }
  std::string fault() const {
    return rounding > std::min(radius, 0.5 * height)
               ? "a cylinder's rounding must be at most its radius and half its height"
               : "";
  }
  template <class T>
  T distance(const Point<T>& p) const {
    return intersect_orthogonal(length(p.x, p.z) - T(radius - rounding),
                                abs(p.y) - T(0.5 * height - rounding)) -
           T(rounding);
  }
  Box3d bounds() const {
    const Vec3d half(radius, 0.5 * height, radius);
    return {-half, half};
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(cylinder) { return primitive_kind<Cylinder>("cylinder"); }
