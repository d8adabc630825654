// SPDX-License-Identifier: Apache-2.0
// The exact distance to a regular prism: the farthest side of the polygon, or the nearest corner.
#include <vug/base/maths.h>
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

#include <array>

namespace vug::field {
namespace {

constexpr int kMostSides = 64;

struct PrismShape {
  int sides;
  double half_height, apothem, half_side;
  std::array<double, kMostSides> x{}, z{};  // Normals of the sides.

  template <class T>
  T distance(const Point<T>& p) const {
    return intersect_orthogonal(polygon(p.x, p.z), abs(p.y) - T(half_height));
  }
  template <class T>
  T polygon(const T& px, const T& pz) const {
    T height = px * T(x[0]) + pz * T(z[0]), along = pz * T(x[0]) - px * T(z[0]);
    for (size_t i = 1; i < static_cast<size_t>(sides); ++i) {
      const T next = px * T(x[i]) + pz * T(z[i]);
      along = select(next > height, pz * T(x[i]) - px * T(z[i]), along);
      height = max(next, height);
    }
    const T outside = height - T(apothem), beyond = abs(along) - T(half_side);
    return select(both(outside > T(0.0), beyond > T(0.0)), length(outside, beyond), outside);
  }
  Box3d bounds() const {
    const double corner = std::sqrt(apothem * apothem + half_side * half_side);
    Box3d box;
    for (size_t i = 0; i < static_cast<size_t>(sides); ++i) {
      const Vec3d foot(apothem * x[i], 0, apothem * z[i]), tangent(-z[i], 0, x[i]);
      box.extendBy(foot + tangent * half_side);
      box.extendBy(foot - tangent * half_side);
    }
    box.min.y = -half_height;
    box.max.y = half_height;
    return intersection(grown(box, 1e-12 * corner), {Vec3d(-corner, -half_height, -corner),
                                                     Vec3d(corner, half_height, corner)});
  }
};

struct Prism {
  int sides = 6;
  double radius = 0.5;
  double height = 1;

  static void describe(Schema<Prism>& s) {
    s.doc(
         "A regular polygon extruded along y, with its first side facing +x, centred at the "
         "origin.")
        .param("sides", &Prism::sides,
               {.doc = "number of sides of the polygon", .min = 3, .max = kMostSides})
        .param("radius", &Prism::radius, positive_length("distance from the axis to the corners"))
        .param("height", &Prism::height, positive_length("height from end to end"));
  }
  PrismShape shape() const {
    PrismShape out{sides, 0.5 * height, radius * maths::cos(kPi / sides),
                   radius * maths::sin(kPi / sides)};
    for (int i = 0; i < sides; ++i) {
      out.x[static_cast<size_t>(i)] = maths::cos(2 * kPi * i / sides);
      out.z[static_cast<size_t>(i)] = maths::sin(2 * kPi * i / sides);
    }
    return out;
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(prism) { return primitive_kind<Prism>("prism"); }
