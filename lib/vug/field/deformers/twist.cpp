// SPDX-License-Identifier: Apache-2.0
// Slices across the axis rotate in proportion to their height (barr1984). A point at radius r moves
// by rate * r per metre of height, so the map stretches by s/2 + sqrt(1 + s^2/4), s = rate * r.
// Values are divided by that, and points beyond the solid's radius are first projected onto it.
#include <vug/field/enclosed.h>

#include <cmath>

namespace vug::field {
namespace {

struct Twist {
  Field field;
  double rate = 1;
  Vec3d axis{0, 1, 0};

  static void describe(Schema<Twist>& s) {
    s.doc(
         "Rotates a solid about an axis through the origin, in proportion to the position along "
         "it; values become a lower bound of the distance.")
        .cite("barr1984")
        .param("field", &Twist::field,
               {.doc = "the solid to twist, of finite size", .required = true})
        .param("rate", &Twist::rate,
               {.doc = "rotation per metre, such as 30deg/m; plain numbers are in radians",
                .dimension = Dimension::per_length})
        .param("axis", &Twist::axis, {.doc = "direction of the axis, of any length but 0"});
  }
  std::string fault() const {
    if (!(axis.length2() > 0)) return "the axis must not be zero";
    return is_finite(field.bounds()) ? "" : "only a solid of finite size can be twisted";
  }
};

struct Twisting {
  double rate, radius, stretch;

  template <class T>
  Point<T> map(const Point<T>& p) const {
    const T inwards = T(radius) / max(length(p.x, p.z), T(radius));
    const T angle = p.y * T(rate), c = cos(angle), s = sin(angle);
    const T x = p.x * inwards, z = p.z * inwards;
    return {c * x - s * z, p.y, s * x + c * z};
  }
  Ball map(const Ball& ball) const {
    return {vector(map(point(ball.centre))), ball.radius * stretch};
  }
  double scale() const { return 1 / stretch; }
  Traits traits(const Traits& child) const { return deformed_traits(child); }
};

Field twisted(const Field& field, double rate) {
  const Box3d& box = field.bounds();
  const double r = radius_about_y(box), s = std::fabs(rate) * r;
  const Twisting twisting{rate, r, 0.5 * s + std::sqrt(1 + 0.25 * s * s)};
  const Field within(std::make_shared<DeformerNode<Twisting>>("twist", twisting, field.node()));
  return enclosed(within_hull(within, {r, r, box.min.y, box.min.y + 1}),
                  {{-r, box.min.y, -r}, {r, box.max.y, r}});
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(twist) {
  return field_kind<Twist>("twist", "deformer", [](const Twist& t) {
    return along_axis(t.field, {0, 1, 0}, t.axis,
                      [&](const Field& f) { return twisted(f, t.rate); });
  });
}
