// A plugin that brings one primitive, written as those in lib/vug/field/primitives are:
//   volume glass = level_set(lens(radius: 2m, thickness: 1m), voxel: 5cm)
#include <vug/field/primitive.h>
#include <vug/loading/plugin.h>

#include <cmath>

namespace vug::field {
namespace {

/// What two balls of one size have in common: the distance is that to the farther of both surfaces,
/// exact on the surface and never more than the true one.
struct Lens {
  double radius = 1;
  double thickness = 0.5;

  static void describe(Schema<Lens>& s) {
    s.doc("A lens about the origin, its axis upright: what two balls have in common.")
        .param("radius", &Lens::radius, positive_length("of both balls"))
        .param("thickness", &Lens::thickness,
               positive_length("along the axis, less than the balls' diameter"));
  }
  std::string fault() const {
    return thickness < 2 * radius ? "" : "a lens is thinner than its balls";
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
