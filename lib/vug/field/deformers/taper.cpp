// SPDX-License-Identifier: Apache-2.0
// Slices across the axis scale linearly with their height (barr1984), between the ends of the
// solid's box. At radius R of the child the inverse map stretches by the norm of ((1/s, R m/s), (0,
// 1)), where s is the factor and m its slope; values are divided by the maximum.
#include <vug/field/enclosed.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct Taper {
  Field field;
  double from = 1;
  double to = 0.5;
  Vec3d axis{0, 1, 0};

  static void describe(Schema<Taper>& s) {
    s.doc(
         "Narrows a solid along an axis through the origin; values become a lower bound of the "
         "distance.")
        .cite("barr1984")
        .param("field", &Taper::field,
               {.doc = "the solid to taper, of finite size", .required = true})
        .param("from", &Taper::from,
               {.doc = "factor on its width at the low end", .min = 0.01, .max = 100})
        .param("to", &Taper::to, {.doc = "factor at the high end", .min = 0.01, .max = 100})
        .param("axis", &Taper::axis, {.doc = "direction of the axis, of any length but 0"});
  }
  std::string fault() const {
    if (!(axis.length2() > 0)) return "the axis must not be zero";
    return is_finite(field.bounds()) ? "" : "only a solid of finite size can be tapered";
  }
};

struct Tapering {
  double from, to, low, height, radius, stretch;

  template <class T>
  Point<T> map(const Point<T>& p) const {
    const T t = clamp((p.y - T(low)) * T(1 / height), T(0.0), T(1.0));
    const T factor = T(from) + T(to - from) * t;
    const T x = p.x / factor, z = p.z / factor;
    const T inwards = T(radius) / max(length(x, z), T(radius));
    return {x * inwards, p.y, z * inwards};
  }
  Ball map(const Ball& ball) const {
    return {vector(map(point(ball.centre))), ball.radius * stretch};
  }
  double scale() const { return 1 / stretch; }
  Traits traits(const Traits& child) const { return deformed_traits(child); }
};

Field tapered(const Field& field, const Taper& taper) {
  const Box3d& box = field.bounds();
  const double r = radius_about_y(box), height = std::max(box.size().y, 1e-9);
  const double least = std::min(taper.from, taper.to), most = std::max(taper.from, taper.to);
  const double a = 1 / least, b = r * (most - least) / height / least;
  const double f = a * a + b * b + 1;
  const double stretch = std::sqrt(0.5 * (f + std::sqrt(f * f - 4 * a * a)));
  const Tapering tapering{taper.from, taper.to, box.min.y, height, r, std::max(1.0, stretch)};
  const double wide = r * most;
  const Field within(std::make_shared<DeformerNode<Tapering>>("taper", tapering, field.node()));
  return enclosed(
      within_hull(within, {r * taper.from, r * taper.to, box.min.y, box.min.y + height}),
      {{-wide, box.min.y, -wide}, {wide, box.max.y, wide}});
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(taper) {
  return field_kind<Taper>("taper", "deformer", [](const Taper& t) {
    return along_axis(t.field, {0, 1, 0}, t.axis, [&](const Field& f) { return tapered(f, t); });
  });
}
