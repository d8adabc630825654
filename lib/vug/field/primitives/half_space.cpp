// SPDX-License-Identifier: Apache-2.0
// n . p - offset: the half-space behind a plane.
#include <vug/field/primitive.h>

namespace vug::field {
namespace {

struct HalfSpaceShape {
  Vec3d normal;
  double offset;

  template <class T>
  T distance(const Point<T>& p) const {
    return dot(p, constant<T>(normal)) - T(offset);
  }
  Box3d bounds() const {
    Box3d box = infinite_box();
    for (int axis = 0; axis < 3; ++axis) {
      if (normal[axis] == 1) box.max[axis] = offset;
      if (normal[axis] == -1) box.min[axis] = -offset;
    }
    return box;
  }
  HalfSpaceShape translated(const Vec3d& by) const { return {normal, offset + normal.dot(by)}; }
};

struct HalfSpace {
  Vec3d normal{0, 1, 0};
  double offset = 0;

  static void describe(Schema<HalfSpace>& s) {
    s.doc("The half-space behind a plane.")
        .param("normal", &HalfSpace::normal,
               {.doc = "normal out of the solid, of any length but 0"})
        .param("offset", &HalfSpace::offset,
               any_length("distance of the plane from the origin along the normal"));
  }
  std::string fault() const {
    return normal.length() > 0 ? "" : "a half-space's normal must not be 0";
  }
  HalfSpaceShape shape() const { return {normal.normalized(), offset}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(half_space) { return primitive_kind<HalfSpace>("half_space"); }
