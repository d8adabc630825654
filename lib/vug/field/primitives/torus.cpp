// SPDX-License-Identifier: Apache-2.0
// The exact distance to a torus: a disc rotated about the y axis (hart1996, appendix A).
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct Torus {
  double radius = 1;
  double tube = 0.25;

  static void describe(Schema<Torus>& s) {
    s.doc("A torus about the y axis, centred at the origin.")
        .cite("hart1996")
        .param("radius", &Torus::radius,
               positive_length("distance from the centre to the tube's middle"))
        .param("tube", &Torus::tube, positive_length("radius of the tube, at most the radius"));
  }
  std::string fault() const {
    return tube > radius ? "a torus's tube must be at most as wide as its radius" : "";
  }
  template <class T>
  T distance(const Point<T>& p) const {
    return length(length(p.x, p.z) - T(radius), p.y) - T(tube);
  }
  Box3d bounds() const {
    const Vec3d half(radius + tube, tube, radius + tube);
    return {-half, half};
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(torus) { return primitive_kind<Torus>("torus"); }
