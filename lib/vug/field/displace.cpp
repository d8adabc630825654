#include <vug/field/displace.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

double greatest(Interval range) { return std::max(std::fabs(range.lo), std::fabs(range.hi)); }

class DisplaceNode final : public EvaluationModes<DisplaceNode> {
 public:
  DisplaceNode(Traits traits, NodePtr child, Noise noise, Displacement how)
      : EvaluationModes(std::move(traits)),
        child_(std::move(child)),
        noise_(std::move(noise)),
        how_(std::move(how)) {}

  static bool feels_slope(const Displacement& how) {
    return how.floor != how.wall || how.ceiling != how.wall;
  }
  static Traits traits_of(const Traits& child, const Noise& noise, const Displacement& how);

  template <class T>
  T at(const Point<T>& p) const {
    T push = noise_.field.node()->eval(p) * T(how_.amount);
    if (feels_slope(how_)) {
      const T h(how_.feel);
      push = push * facing(child_->eval(Point<T>{p.x, p.y + h, p.z}),
                           child_->eval(Point<T>{p.x, p.y - h, p.z}));
    } else {
      push = push * T(how_.wall);
    }
    if (how_.by) push = push * share(how_.by->field.node()->eval(p));
    return child_->eval(p) - push;
  }

  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    const auto size = static_cast<size_t>(count);
    T* push = frame.template take<T>(size);
    noise_.field.node()->eval(points, count, push, scratch);
    T* other = frame.template take<T>(size);
    if (feels_slope(how_)) {
      auto* moved = frame.template take<Point<Pack>>(size);
      T* above = frame.template take<T>(size);
      const Pack h(how_.feel);
      for (int i = 0; i < count; ++i) moved[i] = {points[i].x, points[i].y + h, points[i].z};
      child_->eval(moved, count, above, scratch);
      for (int i = 0; i < count; ++i) moved[i].y = points[i].y - h;
      child_->eval(moved, count, other, scratch);
      for (int i = 0; i < count; ++i)
        push[i] = push[i] * T(how_.amount) * facing(above[i], other[i]);
    } else {
      for (int i = 0; i < count; ++i) push[i] = push[i] * T(how_.amount) * T(how_.wall);
    }
    if (how_.by) {
      how_.by->field.node()->eval(points, count, other, scratch);
      for (int i = 0; i < count; ++i) push[i] = push[i] * share(other[i]);
    }
    child_->eval(points, count, out, scratch);
    for (int i = 0; i < count; ++i) out[i] = out[i] - push[i];
  }

  Restriction restrict_to(const Ball& ball) const override {
    const bool slope = feels_slope(how_);
    const Restriction near = child_->restrict_to(ball);
    Interval push = noise_.field.node()->restrict_to(ball).range * Interval(how_.amount);
    const double low = std::min({how_.floor, how_.wall, how_.ceiling}),
                 high = std::max({how_.floor, how_.wall, how_.ceiling});
    push *= Interval(low, high);
    if (how_.by) push *= share(how_.by->field.node()->restrict_to(ball).range);
    Restriction out;
    out.range = near.range - push;
    NodePtr inner = near.node;
    if (slope) inner = child_->restrict_to({ball.centre, ball.radius + how_.feel}).node;
    if (inner) out.node = std::make_shared<DisplaceNode>(this->traits(), inner, noise_, how_);
    return out;
  }
  std::string name() const override { return "displace"; }
  std::vector<NodePtr> children() const override {
    std::vector<NodePtr> out = {child_, noise_.field.node()};
    if (how_.by) out.push_back(how_.by->field.node());
    return out;
  }

 private:
  /// The factor for a surface whose outward slope along y is (above - below) / 2h.
  template <class T>
  T facing(const T& above, const T& below) const {
    const T up = clamp((above - below) * T(0.5 / how_.feel), T(-1.0), T(1.0));
    return T(how_.wall) + T(how_.floor - how_.wall) * square(max(up, T(0.0))) +
           T(how_.ceiling - how_.wall) * square(min(up, T(0.0)));
  }
  template <class T>
  static T share(const T& noise) {
    return clamp(noise * T(0.5) + T(0.5), T(0.0), T(1.0));
  }

  NodePtr child_;
  Noise noise_;
  Displacement how_;
};

Traits DisplaceNode::traits_of(const Traits& child, const Noise& noise, const Displacement& how) {
  const double factor =
      std::max({std::fabs(how.floor), std::fabs(how.wall), std::fabs(how.ceiling)});
  const double size = std::fabs(how.amount) * greatest(noise.range);
  Traits out = child;
  out.lipschitz += std::fabs(how.amount) * factor * noise.field.lipschitz();
  if (feels_slope(
          how))  // The slope of the factor in `up` is at most 2 * difference, that of `up` L / h.
    out.lipschitz += size * 2 *
                     std::max(std::fabs(how.floor - how.wall), std::fabs(how.ceiling - how.wall)) *
                     child.lipschitz / how.feel;
  if (how.by) out.lipschitz += size * factor * 0.5 * how.by->field.lipschitz();
  out.exactness = Exactness::sign;
  out.bounds = child.bounds_below(size * factor);
  out.growth = child.growth_rate();
  return out;
}

}  // namespace

Field displaced(const Field& field, const Noise& noise, const Displacement& how) {
  if (how.amount == 0) return field;
  return Field(std::make_shared<DisplaceNode>(
      DisplaceNode::traits_of(field.node()->traits(), noise, how), field.node(), noise, how));
}

}  // namespace vug::field
