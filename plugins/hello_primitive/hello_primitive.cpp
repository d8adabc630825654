// SPDX-License-Identifier: Apache-2.0
// A plugin with one primitive, written like those in lib/vug/field/primitives:
//   volume glass = level_set(lens(radius: 2m, thickness: 1m), voxel: 5cm)
#include <vug/field/primitive.h>
#include <vug/loading/plugin.h>

#include <cmath>

namespace vug::field {
namespace {

/// The intersection of two balls of equal size. The value is the distance to the farther of both
/// surfaces: exact on the surface and nowhere greater than the true distance.
struct Lens {
  double radius = 1;
  double thickness = 0.5;

  static void describe(Schema<Lens>& s) {
    s.doc("A lens about the origin with a vertical axis: the intersection of two balls.")
        .param("radius", &Lens::radius, positive_length("of both balls"))
        .param("thickness", &Lens::thickness,
               positive_length("along the axis, less than the balls' diameter"));
  }
  std::string fault() const {
    return thickness < 2 * radius
               ? ""
               : "the thickness of a lens must be less than the diameter of its balls";
  }
  template <class T>
  T distance(const Point<T>& p) const {
    const T apart = T(radius - thickness / 2);
    const T aside = p.x * p.x + p.z * p.z;
    const T up = p.y + apart, down = p.y - apart;
    return max(sqrt(aside + up * up), sqrt(aside + down * down)) - T(radius);
  }
  Box3d bounds() const {
    const double rim = std::sqrt(thickness * (radius - thickness / 4));
    return {Vec3d(-rim, -thickness / 2, -rim), Vec3d(rim, thickness / 2, rim)};
  }
  Exactness exactness() const { return Exactness::eikonal; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(lens) { return primitive_kind<Lens>("lens"); }

VUG_PLUGIN(kinds) { kinds.add(vug::field::lens_kind()); }
