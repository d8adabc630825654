// SPDX-License-Identifier: Apache-2.0
// The nearest point of a solid of revolution lies in the half-plane of the axis and the point.
// There the distance is that to the nearest side of the polygon, and a point is inside if the
// horizontal ray away from the axis crosses an odd number of sides.
#include <vug/field/enclosing_ball.h>
#include <vug/field/lathe.h>
#include <vug/field/numbers/value_of.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <type_traits>

namespace vug::field {
namespace {

/// A point of the profile's half-plane relative to a side, over any number type.
template <class T>
struct SideLine {
  T x, y;     ///< The point from which it starts.
  T u, v;     ///< From there to its end.
  T inverse;  ///< 1 / |(u, v)|^2

  /// The square of the distance of the point at radius r and height h.
  T squared_distance(const T& r, const T& h) const {
    const T dx = r - x, dy = h - y;
    const T t = clamp((dx * u + dy * v) * inverse, T(0.0), T(1.0));
    return square(dx - u * t) + square(dy - v * t);
  }
};

struct Side {
  SideLine<double> line;
  double low, high;  ///< Heights of the ends.
  double upward;     ///< 1 if it rises, -1 if it falls.

  Side(const Vec2d& a, const Vec2d& b)
      : line{a.x, a.y, b.x - a.x, b.y - a.y, 1 / (b - a).length2()},
        low(std::min(a.y, b.y)),
        high(std::max(a.y, b.y)),
        upward(b.y < a.y ? -1 : 1) {}

  double widest() const { return line.x + std::max(line.u, 0.0); }
  void add_to(Digester& digester) const { digester(line, low, high, upward); }
};

/// The sides of a part of space. All numbers are also kept in single precision, for batches.
class Sides {
 public:
  Sides(std::vector<Side> near, std::vector<Side> crossed, double sign)
      : near_(std::move(near)), crossed_(std::move(crossed)), sign_(sign) {
    lines_.reserve(near_.size());
    for (const Side& side : near_) {
      const SideLine<double>& l = side.line;
      lines_.push_back({static_cast<float>(l.x), static_cast<float>(l.y), static_cast<float>(l.u),
                        static_cast<float>(l.v), static_cast<float>(l.inverse)});
    }
  }

  /// The least square of a distance, and the index of the side that has it.
  template <class S>
  struct Nearest {
    S squared, which;
  };
  template <class S>
  Nearest<S> nearest(const S& r, const S& h) const {
    Nearest<S> out{S(1e30), S(0.0)};
    for (size_t i = 0; i < near_.size(); ++i) {
      const S squared = line<S>(i).squared_distance(r, h);
      out.which = select(out.squared < squared, out.which, S(static_cast<double>(i)));
      out.squared = min(out.squared, squared);
    }
    return out;
  }
  /// 1 outside, -1 inside. A side is farther from the axis than the point if the point is on its
  /// left going up.
  template <class S>
  S sign(const S& r, const S& h) const {
    S out(sign_);
    const auto [lowest, highest] = extremes(h);
    for (const Side& side : crossed_) {
      if (highest < side.low || lowest > side.high) continue;
      const S dx = r - S(side.line.x), dy = h - S(side.line.y);
      const S left = (S(side.line.u) * dy - S(side.line.v) * dx) * S(side.upward);
      const S flip = select(left < S(0.0), S(1.0), S(-1.0));
      out = out * select(h < S(side.low), S(1.0), select(h < S(side.high), flip, S(1.0)));
    }
    return out;
  }
  /// The sides that are nearest at each point.
  template <class T>
  SideLine<T> lines(double which) const {
    const SideLine<double>& l = near_[static_cast<size_t>(which)].line;
    return {T(l.x), T(l.y), T(l.u), T(l.v), T(l.inverse)};
  }
  template <class T>
  SideLine<T> lines(const Pack& which) const {
    float index[Pack::kLanes], gathered[5][Pack::kLanes];
    which.store(index);
    for (int k = 0; k < Pack::kLanes; ++k) {
      const SideLine<float>& l = lines_[static_cast<size_t>(index[k])];
      gathered[0][k] = l.x, gathered[1][k] = l.y;
      gathered[2][k] = l.u, gathered[3][k] = l.v, gathered[4][k] = l.inverse;
    }
    const auto constant = [&](int i) {
      const Pack zero(0.0);
      return T(Pack::load(gathered[i]), zero, zero, zero);
    };
    return {constant(0), constant(1), constant(2), constant(3), constant(4)};
  }

  const std::vector<Side>& near() const { return near_; }
  const std::vector<Side>& crossed() const { return crossed_; }
  double sign() const { return sign_; }

  void add_to(Digester& digester) const { digester(near_, crossed_, sign_); }

 private:
  template <class S>
  SideLine<S> line(size_t i) const {
    if constexpr (std::is_same_v<S, double>) {
      return near_[i].line;
    } else {
      const SideLine<float>& l = lines_[i];
      return {S(l.x), S(l.y), S(l.u), S(l.v), S(l.inverse)};
    }
  }

  static std::pair<double, double> extremes(double h) { return {h, h}; }
  static std::pair<double, double> extremes(const Pack& h) {
    float lanes[Pack::kLanes];
    h.store(lanes);
    const auto [low, high] = std::minmax_element(lanes, lanes + Pack::kLanes);
    const double slack = 1e-6 * std::max(std::fabs(*low), std::fabs(*high));
    return {*low - slack, *high + slack};
  }

  std::vector<Side> near_;     // Those that can be nearest.
  std::vector<Side> crossed_;  // Those that a ray from a point away from the axis can cross.
  double sign_;                // Without crossings.
  std::vector<SideLine<float>> lines_;
};

class LatheNode final : public EvaluationModes<LatheNode> {
 public:
  LatheNode(Traits traits, std::string name, Sides sides)
      : EvaluationModes(std::move(traits)), name_(std::move(name)), sides_(std::move(sides)) {}

  /// Derivatives are computed for the nearest side alone.
  template <class T>
  T at(const Point<T>& p) const {
    using S = std::decay_t<decltype(value_of(p.x))>;
    const T r = length(p.x, p.z);
    if constexpr (std::is_same_v<S, T>) {
      return sides_.sign(r, p.y) * sqrt(sides_.nearest(r, p.y).squared);
    } else {
      const auto nearest = sides_.nearest(r.v, p.y.v);
      const T squared = sides_.template lines<T>(nearest.which).squared_distance(r, p.y);
      return T(sides_.sign(r.v, p.y.v), S(0.0), S(0.0), S(0.0)) * sqrt(squared);
    }
  }
  Interval at(const Point<Interval>& p) const {
    const Ball ball = enclosing_ball(p);
    return centre_form(at(field::point(ball.centre)), ball);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = at(point_for<T>(points[i]));
  }

  /// Keeps the sides that can be nearest to a point of the ball, and those that its rays can cross.
  /// A ball that the surface does not pass through has one sign.
  Restriction restrict_to(const Ball& ball) const override {
    const double r = length(ball.centre.x, ball.centre.z), h = ball.centre.y;
    thread_local std::vector<double> squares;
    squares.clear();
    double least = kInfinity;
    for (const Side& side : sides_.near()) {
      squares.push_back(side.line.squared_distance(r, h));
      least = std::min(least, squares.back());
    }
    least = std::sqrt(least);
    const double sign = sides_.sign(r, h);
    const double slack = 1e-6 * (1 + length(r, h) + ball.radius);
    const double reach = ball.radius + slack;
    const Interval range = centre_form(sign * least, ball);
    const double farthest = square(least + 2 * reach);
    const auto near = static_cast<size_t>(std::count_if(
        squares.begin(), squares.end(), [&](double squared) { return squared <= farthest; }));
    const bool passes = least <= reach;
    const auto crosses = [&](const Side& side) {
      return passes && side.low <= h + reach && side.high >= h - reach &&
             side.widest() >= r - reach;
    };
    const auto crossed = static_cast<size_t>(
        std::count_if(sides_.crossed().begin(), sides_.crossed().end(), crosses));
    if (near == sides_.near().size() && crossed == sides_.crossed().size()) return {range, nullptr};
    std::vector<Side> kept, rest;
    kept.reserve(near), rest.reserve(crossed);
    for (size_t i = 0; i < squares.size(); ++i)
      if (squares[i] <= farthest) kept.push_back(sides_.near()[i]);
    std::copy_if(sides_.crossed().begin(), sides_.crossed().end(), std::back_inserter(rest),
                 crosses);
    return {range, std::make_shared<LatheNode>(
                       traits(), name_,
                       Sides(std::move(kept), std::move(rest), passes ? sides_.sign() : sign))};
  }
  std::string name() const override { return name_; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, sides_); }

 private:
  std::string name_;
  Sides sides_;
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
  const std::vector<Side> sides = sides_of(outline);
  return Field(std::make_shared<LatheNode>(std::move(traits), name, Sides(sides, sides, 1)));
}

}  // namespace vug::field
