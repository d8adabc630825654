// SPDX-License-Identifier: Apache-2.0
// |n . p| - thickness / 2: the region between two parallel planes.
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct SlabShape {
  Vec3d normal;
  double half;

  template <class T>
  T distance(const Point<T>& p) const {
    return abs(dot(p, constant<T>(normal))) - T(half);
  }
  Box3d bounds() const {
    Box3d box = infinite_box();
    for (int axis = 0; axis < 3; ++axis)
      if (std::fabs(normal[axis]) == 1) {
        box.min[axis] = -half;
        box.max[axis] = half;
      }
    return box;
  }
};

struct Slab {
  Vec3d normal{0, 1, 0};
  double thickness = 1;

  static void describe(Schema<Slab>& s) {
    s.doc("The region between two parallel planes, centred at the origin.")
        .param("normal", &Slab::normal, {.doc = "normal of the slab, of any length but 0"})
        .param("thickness", &Slab::thickness, positive_length("thickness from plane to plane"));
  }
  std::string fault() const { return normal.length() > 0 ? "" : "a slab's normal must not be 0"; }
  SlabShape shape() const { return {normal.normalized(), 0.5 * thickness}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(slab) { return primitive_kind<Slab>("slab"); }
