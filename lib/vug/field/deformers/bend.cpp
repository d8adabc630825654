// SPDX-License-Identifier: Apache-2.0
// A bar along x is wound about the line x = 0, y = 1/rate, parallel to z (barr1984). The inverse
// map is (theta / rate, 1/rate - rho). It stretches by 1 / (rate * rho), which is largest at the
// solid's innermost radius; values are divided by this factor. Inside that radius there is no
// solid, and the distance to it is a bound; the map's value fades towards the line, where it has no
// limit. Beyond half a turn a point is seen from both ends, so two windings are united.
#include <vug/field/boolean.h>
#include <vug/field/enclosed.h>
#include <vug/field/modifier.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct Bend {
  Field field;
  double rate = 0.5;
  Vec3d axis{0, 0, 1};

  static void describe(Schema<Bend>& s) {
    s.doc(
         "Bends a solid that lies along x upwards, about an axis parallel to z; values become a "
         "lower bound of the distance.")
        .cite("barr1984")
        .param("field", &Bend::field,
               {.doc = "the solid to bend, of finite size", .required = true})
        .param("rate", &Bend::rate,
               {.doc = "rotation per metre of length, such as 30deg/m; plain numbers are in "
                       "radians; negative bends downwards",
                .dimension = Dimension::per_length})
        .param("axis", &Bend::axis, {.doc = "rotates the deformation from z to this direction"});
  }
  std::string fault() const {
    if (!(axis.length2() > 0)) return "the axis must not be zero";
    const Box3d& box = field.bounds();
    if (!is_finite(box)) return "only a solid of finite size can be bent";
    return "";
  }
};

struct Winding {
  double radius;  // Radius of the bend, 1 / rate.
  double inner;   // Innermost radius of the solid.
  bool other;     // Seen from the other end.

  template <class T>
  Point<T> map(const Point<T>& p) const {
    const T up = T(radius) - p.y;
    const T rho = max(length(p.x, up), T(inner));
    T angle = atan2(p.x, up);
    if (other) angle = angle - select(angle < T(0.0), T(-2 * kPi), T(2 * kPi));
    return {angle * T(radius), T(radius) - rho, p.z};
  }
  Ball map(const Ball& ball) const {
    const Vec3d& c = ball.centre;
    const Vec3d image = vector(map(point(c)));
    const double x = c.x, up = radius - c.y, rho = std::sqrt(x * x + up * up);
    // If the ball meets the line or the branch cut of the angle, its image consists of two pieces
    // or a ring.
    const bool whole = rho <= ball.radius || (std::fabs(x) <= ball.radius &&
                                              (other ? up > -ball.radius : up < ball.radius));
    if (whole) return {{0, image.y, image.z}, 2 * kPi * radius + ball.radius};
    return {image, ball.radius * std::max(1.0, radius / (rho - ball.radius))};
  }
  double scale() const { return std::min(1.0, inner / radius); }
  Traits traits(const Traits& child) const { return deformed_traits(child); }
};

struct Core {
  double radius, inner;

  template <class T>
  T apply(const T& value, const Point<T>& p) const {
    const T rho = length(p.x, T(radius) - p.y);
    const T faded = min(value, T(inner)) * min(rho * T(1 / inner), T(1.0));
    return select(rho < T(inner), max(faded, T(inner) - rho), faded);
  }
  Traits traits(const Traits& child) const {
    Traits out = child;
    out.lipschitz = child.lipschitz + 1;
    return out;
  }
  Interval range(Interval child) const { return hull(min(child, Interval(inner)), {0, inner}); }
};

Box3d bent_box(const Box3d& box, double radius) {
  const double reach = std::max(std::fabs(box.min.x), std::fabs(box.max.x));
  const double angle = std::min(reach / radius, kPi);
  const double outer = radius - box.min.y, inner = radius - box.max.y;
  const double c = maths::cos(angle);
  const double wide = angle >= 0.5 * kPi ? outer : outer * maths::sin(angle);
  return {{-wide, box.min.y, box.min.z}, {wide, radius - (c > 0 ? inner : outer) * c, box.max.z}};
}

Field bent(const Field& field, double rate) {
  if (rate == 0) return field;
  if (rate < 0) {
    const Transform flip = Transform::scaling({1, -1, 1});
    return transformed(bent(transformed(field, flip), -rate), flip);
  }
  const Box3d& box = field.bounds();
  const double radius = 1 / rate, inner = radius - box.max.y;
  if (inner <= 1e-3 * radius)
    throw Error(ErrorCode::bad_input, "the bend is so tight that its axis runs through the solid");
  if (std::max(-box.min.x, box.max.x) > kPi * radius)
    throw Error(ErrorCode::bad_input, "the bend winds the solid by more than a full turn");
  using Node = DeformerNode<Winding>;
  const Field once(std::make_shared<Node>("bend", Winding{radius, inner, false}, field.node()));
  const Field again(std::make_shared<Node>("bend", Winding{radius, inner, true}, field.node()));
  const Field faded(std::make_shared<ModifierNode<Core>>("bend core", Core{radius, inner},
                                                         unite({once, again}).node()));
  return enclosed(faded, bent_box(box, radius));
}

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(bend) {
  return field_kind<Bend>("bend", "deformer", [](const Bend& b) {
    return along_axis(b.field, {0, 0, 1}, b.axis, [&](const Field& f) { return bent(f, b.rate); });
  });
}
