// SPDX-License-Identifier: Apache-2.0
// The exact distance to a square pyramid. Its mirror symmetries fold space to x >= z >= 0, where
// only one slanted face, its edge to the tip and the base can be nearest.
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

namespace vug::field {
namespace {

struct PyramidShape {
  double half, height;  // Half the base, and the total height.
  ProfileEdge slope{half, -0.5 * height, 0, 0.5 * height};
  double slant = std::sqrt(half * half + height * height);
  double edge2 = 2 * half * half + height * height;  // Squared length of the edge to the tip.

  template <class T>
  T distance(const Point<T>& p) const {
    const T ax = abs(p.x), az = abs(p.z), x = max(ax, az), z = min(ax, az);
    const T up = p.y + T(0.5 * height), face = slope.height(x, p.y);
    const T inside = max(face, -up);
    // Along the face from the edge of the base up; the face narrows towards the tip.
    const T along = ((T(half) - x) * T(half) + up * T(height)) * T(1 / slant);
    const auto before_face =
        both(both(face > T(0.0), along > T(0.0)), z < T(half) - along * T(half / slant));
    const T base = square(max(x - T(half), T(0.0))) + square(up) + square(max(z - T(half), T(0.0)));
    // The edge runs from (half, 0, half) by (-half, height, -half) above the base.
    const T share =
        clamp(((T(half) - x) * T(half) + (T(half) - z) * T(half) + up * T(height)) * T(1 / edge2),
              T(0.0), T(1.0));
    const T shrunk = T(half) * (T(1.0) - share);
    const T edge = square(x - shrunk) + square(up - share * T(height)) + square(z - shrunk);
    return select(inside > T(0.0), select(before_face, face, sqrt(min(base, edge))), inside);
  }
  Box3d bounds() const {
    const Vec3d corner(half, 0.5 * height, half);
    return {-corner, corner};
  }
};

struct Pyramid {
  double base = 1;
  double height = 1;

  static void describe(Schema<Pyramid>& s) {
    s.doc("A square pyramid with its tip up and the origin halfway between base and tip.")
        .param("base", &Pyramid::base, positive_length("side of the base"))
        .param("height", &Pyramid::height, positive_length("height from the base to the tip"));
  }
  PyramidShape shape() const { return {0.5 * base, height}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(pyramid) { return primitive_kind<Pyramid>("pyramid"); }
