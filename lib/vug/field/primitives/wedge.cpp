// SPDX-License-Identifier: Apache-2.0
// The exact distance to a ramp: a right-angled triangle in x and y, extruded along z.
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

namespace vug::field {
namespace {

struct WedgeShape {
  Vec3d size;
  ProfileEdge slope{0.5 * size.x, -0.5 * size.y, -0.5 * size.x, 0.5 * size.y};

  template <class T>
  T distance(const Point<T>& p) const {
    return intersect_orthogonal(triangle(p.x, p.y), abs(p.z) - T(0.5 * size.z));
  }
  template <class T>
  T triangle(const T& x, const T& y) const {
    const T left = x + T(0.5 * size.x), up = y + T(0.5 * size.y);
    const T slant = slope.height(x, y), inside = max(slant, max(-left, -up));
    const T floor2 = square(max(abs(x) - T(0.5 * size.x), T(0.0))) + square(up);
    const T wall2 = square(max(abs(y) - T(0.5 * size.y), T(0.0))) + square(left);
    const T outside =
        select(both(slant > T(0.0), slope.projects_onto(x, y)), slant, sqrt(min(floor2, wall2)));
    return select(inside > T(0.0), outside, inside);
  }
  Box3d bounds() const { return {-0.5 * size, 0.5 * size}; }
};

struct Wedge {
  Vec3d size{1, 1, 1};

  static void describe(Schema<Wedge>& s) {
    s.doc("A ramp: half a box, cut along the diagonal that falls from -x to +x.")
        .param("size", &Wedge::size, positive_length("size of the whole box along x, y and z"));
  }
  WedgeShape shape() const { return {size}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(wedge) { return primitive_kind<Wedge>("wedge"); }
