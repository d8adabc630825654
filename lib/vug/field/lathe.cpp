// SPDX-License-Identifier: Apache-2.0
// The nearest point of a solid of revolution lies in the half-plane of the axis and the point.
// There the distance is that to the nearest side of the polygon, and a point is inside if the
// horizontal ray away from the axis crosses an odd number of sides.
#include <vug/field/enclosing_ball.h>
#include <vug/field/lathe.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

struct Side {
  Vec2d from, along;  ///< The end is from + along.
  double inverse;     ///< 1 / |along|^2
  double low, high;   ///< Heights of the ends.
  double upward;      ///< 1 if it rises, -1 if it falls.

  Side(const Vec2d& a, const Vec2d& b)
      : from(a),
        along(b - a),
        inverse(1 / along.length2()),
        low(std::min(a.y, b.y)),
        high(std::max(a.y, b.y)),
        upward(along.y < 0 ? -1 : 1) {}

  double distance(const Vec2d& p) const {
    const Vec2d offset = p - from;
    return (offset - along * std::clamp(offset.dot(along) * inverse, 0.0, 1.0)).length();
  }
};

class LatheNode final : public EvaluationModes<LatheNode> {
 public:
  LatheNode(Traits traits, std::string name, std::vector<Side> sides)
      : EvaluationModes(std::move(traits)), name_(std::move(name)), sides_(std::move(sides)) {}

  template <class T>
  T at(const Point<T>& p) const {
    const T r = length(p.x, p.z);
    T least(1e30), sign(1.0);
    for (const Side& side : sides_) {
      const T x = r - T(side.from.x), y = p.y - T(side.from.y);
      const T u(side.along.x), v(side.along.y);
      const T t = clamp((x * u + y * v) * T(side.inverse), T(0.0), T(1.0));
      least = min(least, square(x - u * t) + square(y - v * t));
      // The side is farther from the axis than the point if the point is on its left going up.
      const T crossed = select((u * y - v * x) * T(side.upward) < T(0.0), T(1.0), T(-1.0));
      const T flip = select(p.y < T(side.low), T(1.0), select(p.y < T(side.high), crossed, T(1.0)));
      sign = sign * flip;
    }
    return sign * sqrt(least);
  }
  Interval at(const Point<Interval>& p) const {
    const Ball ball = enclosing_ball(p);
    return centre_form(at(field::point(ball.centre)), ball);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = at(point_for<T>(points[i]));
  }

  /// Keeps the sides that can be nearest to a point of the ball, and those that its rays cross.
  Restriction restrict_to(const Ball& ball) const override {
    const Vec2d centre(length(ball.centre.x, ball.centre.z), ball.centre.y);
    double least = kInfinity;
    for (const Side& side : sides_) least = std::min(least, side.distance(centre));
    const double slack = 1e-6 * (1 + centre.length() + ball.radius);
    const double reach = ball.radius + slack;
    std::vector<Side> kept;
    for (const Side& side : sides_) {
      const bool near = side.distance(centre) <= least + 2 * reach;
      const bool level = side.low <= centre.y + reach && side.high >= centre.y - reach;
      if (near || level) kept.push_back(side);
    }
    const Interval range = centre_form(at(field::point(ball.centre)), ball);
    if (kept.size() == sides_.size()) return {range, nullptr};
    return {range, std::make_shared<LatheNode>(traits(), name_, std::move(kept))};
  }
  std::string name() const override { return name_; }

 private:
  std::string name_;
  std::vector<Side> sides_;
};

std::vector<Side> sides_of(const std::vector<Vec2d>& outline) {
  std::vector<Side> sides;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (a != b && (a.x != 0 || b.x != 0)) sides.emplace_back(a, b);
  }
  return sides;
}

}  // namespace

std::string lathe_fault(const std::vector<Vec2d>& outline) {
  double area = 0;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    if (!(std::isfinite(a.x) && std::isfinite(a.y))) return "a corner of the outline is not finite";
    if (a.x < 0) return "a radius is negative; the outline must not cross the axis";
    area += 0.5 * std::fabs(a.x * b.y - a.y * b.x);
  }
  if (outline.size() < 3) return "an outline needs at least three corners";
  return area > 0 ? "" : "the outline has no area";
}

Field lathe(const std::string& name, const std::vector<Vec2d>& outline) {
  Traits traits;
  double widest = 0;
  for (const Vec2d& p : outline) widest = std::max(widest, p.x);
  for (const Vec2d& p : outline) {
    traits.bounds.extendBy(Vec3d(-widest, p.y, -widest));
    traits.bounds.extendBy(Vec3d(widest, p.y, widest));
  }
  return Field(std::make_shared<LatheNode>(std::move(traits), name, sides_of(outline)));
}

}  // namespace vug::field
