// SPDX-License-Identifier: Apache-2.0
// The exact distance to a truncated cone: a trapezoid rotated about the y axis
// (quilez2008distance).
#include <vug/field/primitive.h>
#include <vug/field/profile.h>

#include <algorithm>

namespace vug::field {
namespace {

struct CappedConeShape {
  double bottom, top, height;
  Trapezoid profile{bottom, top, 0.5 * height};

  template <class T>
  T distance(const Point<T>& p) const {
    return profile.distance(length(p.x, p.z), p.y);
  }
  Box3d bounds() const {
    const double widest = std::max(bottom, top);
    const Vec3d half(widest, 0.5 * height, widest);
    return {-half, half};
  }
};

struct CappedCone {
  double bottom = 0.5;
  double top = 0.25;
  double height = 1;

  static void describe(Schema<CappedCone>& s) {
    const ParamSpec radius{.doc = "", .dimension = Dimension::length, .min = 0};
    ParamSpec low = radius, high = radius;
    low.doc = "radius of the lower end";
    high.doc = "radius of the upper end; one of the two may be 0";
    s.doc("A cone truncated across its axis, y, centred at the origin.")
        .cite("quilez2008distance")
        .param("bottom", &CappedCone::bottom, low)
        .param("top", &CappedCone::top, high)
        .param("height", &CappedCone::height, positive_length("height from end to end"));
  }
  std::string fault() const {
    return bottom == 0 && top == 0 ? "one radius of a capped cone must be above 0" : "";
  }
  CappedConeShape shape() const { return {bottom, top, height}; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(capped_cone) { return primitive_kind<CappedCone>("capped_cone"); }
