// SPDX-License-Identifier: Apache-2.0
// The exact distance to a box, optionally with rounded edges (quilez2008distance).
#include <vug/field/primitive.h>

#include <algorithm>

namespace vug::field {
namespace {

struct Box {
  Vec3d size{1, 1, 1};
  double rounding = 0;

  static void describe(Schema<Box>& s) {
    s.doc("A box centred at the origin with its sides along the axes.")
        .cite("quilez2008distance")
        .param("size", &Box::size, positive_length("total size along x, y and z"))
        .param("rounding", &Box::rounding,
               {.doc = "radius of the edges, at most half the smallest size",
                .dimension = Dimension::length,
                .min = 0});
  }
  std::string fault() const {
    return 2 * rounding > std::min({size.x, size.y, size.z})
               ? "a box's rounding must be at most half its smallest size"
               : "";
  }
  template <class T>
  T distance(const Point<T>& p) const {
    const Point<T> q = abs(p) - constant<T>(0.5 * size - Vec3d(rounding));
    const T inside = max(q.x, max(q.y, q.z));
    return select(inside > T(0.0), length(max(q, 0.0)), inside) - T(rounding);
  }
  Box3d bounds() const { return {-0.5 * size, 0.5 * size}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(box) { return primitive_kind<Box>("box"); }
