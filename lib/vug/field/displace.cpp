// SPDX-License-Identifier: Apache-2.0
#include <vug/field/displace.h>
#include <vug/field/evaluates_below.h>
#include <vug/field/numbers/value_of.h>
#include <vug/field/operands.h>
#include <vug/field/translated.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

double greatest(Interval range) { return std::max(std::fabs(range.lo), std::fabs(range.hi)); }

class DisplaceNode final : public EvaluationModes<DisplaceNode>, public LimitModes<DisplaceNode> {
 public:
  DisplaceNode(Traits traits, NodePtr child, Noise noise, Displacement options)
      : EvaluationModes(std::move(traits)),
        child_(std::move(child)),
        noise_(std::move(noise)),
        options_(std::move(options)),
        farthest_(farthest_push(noise_, options_)),
        below_(evaluates_below(*child_)) {}

  static bool depends_on_slope(const Displacement& options) {
    return options.floor != options.wall || options.ceiling != options.wall;
  }
  static Traits traits_of(const Traits& child, const Noise& noise, const Displacement& options);

  template <class T>
  T at(const Point<T>& p) const {
    T push = noise_.field.node()->eval(p) * T(options_.amount);
    if (depends_on_slope(options_)) {
      const T h(options_.feel);
      push = push * facing(child_->eval(Point<T>{p.x, p.y + h, p.z}),
                           child_->eval(Point<T>{p.x, p.y - h, p.z}));
    } else {
      push = push * T(options_.wall);
    }
    if (options_.by) push = push * share(options_.by->field.node()->eval(p));
    return child_->eval(p) - push;
  }

  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* push = frame.template take<T>(static_cast<size_t>(count));
    fill_push(points, count, push, scratch);
    child_->eval(points, count, out, scratch);
    for (int i = 0; i < count; ++i) out[i] = out[i] - push[i];
  }
  /// Noises are only evaluated where they can lower the child's value below the limit.
  template <class T>
  void fill_below(const Point<Pack>* points, const Pack* limits, int count, T* out,
                  Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    const auto size = static_cast<size_t>(count);
    Pack* child_limits = frame.template take<Pack>(size);
    for (int i = 0; i < count; ++i) child_limits[i] = limit_for(limits[i], farthest_);
    if (below_)
      below_->eval_below(points, child_limits, count, out, scratch);
    else
      child_->eval(points, count, out, scratch);
    auto* some = frame.template take<Point<Pack>>(size);
    int* which = frame.template take<int>(size);
    int near = 0;
    for (int i = 0; i < count; ++i) {
      if (!any(!(value_of(out[i]) >= child_limits[i]))) continue;
      some[near] = points[i];
      which[near++] = i;
    }
    T* push = frame.template take<T>(size);
    if (near > 0) fill_push(some, near, push, scratch);
    for (int j = 0; j < near; ++j) out[which[j]] = out[which[j]] - push[j];
  }

  Restriction restrict_to(const Ball& ball) const override {
    const bool slope = depends_on_slope(options_);
    const Restriction near = child_->restrict_to(ball);
    Interval push = noise_.field.node()->restrict_to(ball).range * Interval(options_.amount);
    const double low = std::min({options_.floor, options_.wall, options_.ceiling}),
                 high = std::max({options_.floor, options_.wall, options_.ceiling});
    push *= Interval(low, high);
    if (options_.by) push *= share(options_.by->field.node()->restrict_to(ball).range);
    Restriction out;
    out.range = near.range - push;
    NodePtr inner = near.node;
    if (slope) inner = child_->restrict_to({ball.centre, ball.radius + options_.feel}).node;
    if (inner) out.node = std::make_shared<DisplaceNode>(this->traits(), inner, noise_, options_);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    const auto moved = [&](const Noise& noise) {
      return Noise(field::translated(noise.field, by), noise.range);
    };
    Displacement options = options_;
    if (options.by) options.by = moved(*options.by);
    return std::make_shared<DisplaceNode>(traits().translated(by), field::translated(child_, by),
                                          moved(noise_), std::move(options));
  }
  std::string name() const override { return "displace"; }
  const NodePtr& child() const { return child_; }
  std::vector<NodePtr> children() const override {
    std::vector<NodePtr> out = {child_, noise_.field.node()};
    if (options_.by) out.push_back(options_.by->field.node());
    return out;
  }

 protected:
  void add_to(Digester& digester) const override { digester(child_, noise_, options_); }

 private:
  /// What the noise subtracts from the child's values.
  template <class T>
  void fill_push(const Point<Pack>* points, int count, T* push, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    const auto size = static_cast<size_t>(count);
    noise_.field.node()->eval(points, count, push, scratch);
    T* other = frame.template take<T>(size);
    if (depends_on_slope(options_)) {
      auto* moved = frame.template take<Point<Pack>>(size);
      T* above = frame.template take<T>(size);
      const Pack h(options_.feel);
      for (int i = 0; i < count; ++i) moved[i] = {points[i].x, points[i].y + h, points[i].z};
      child_->eval(moved, count, above, scratch);
      for (int i = 0; i < count; ++i) moved[i].y = points[i].y - h;
      child_->eval(moved, count, other, scratch);
      for (int i = 0; i < count; ++i)
        push[i] = push[i] * T(options_.amount) * facing(above[i], other[i]);
    } else {
      for (int i = 0; i < count; ++i) push[i] = push[i] * T(options_.amount) * T(options_.wall);
    }
    if (options_.by) {
      options_.by->field.node()->eval(points, count, other, scratch);
      for (int i = 0; i < count; ++i) push[i] = push[i] * share(other[i]);
    }
  }
  /// The factor for a surface whose outward slope along y is (above - below) / 2h.
  template <class T>
  T facing(const T& above, const T& below) const {
    const T up = clamp((above - below) * T(0.5 / options_.feel), T(-1.0), T(1.0));
    return T(options_.wall) + T(options_.floor - options_.wall) * square(max(up, T(0.0))) +
           T(options_.ceiling - options_.wall) * square(min(up, T(0.0)));
  }
  template <class T>
  static T share(const T& noise) {
    return clamp(noise * T(0.5) + T(0.5), T(0.0), T(1.0));
  }

  static double greatest_factor(const Displacement& options) {
    return std::max(
        {std::fabs(options.floor), std::fabs(options.wall), std::fabs(options.ceiling)});
  }
  /// A bound of the displacement, in metres.
  static double farthest_push(const Noise& noise, const Displacement& options) {
    const double out = std::fabs(options.amount) * greatest(noise.range) * greatest_factor(options);
    return std::isfinite(out) ? out : kInfinity;
  }

  NodePtr child_;
  Noise noise_;
  Displacement options_;
  double farthest_;
  const EvaluatesBelow* below_;  // The child, or null.
};

Traits DisplaceNode::traits_of(const Traits& child, const Noise& noise,
                               const Displacement& options) {
  const double factor = greatest_factor(options);
  const double size = std::fabs(options.amount) * greatest(noise.range);
  Traits out = child;
  out.lipschitz += std::fabs(options.amount) * factor * noise.field.lipschitz();
  if (depends_on_slope(options))  // The slope of the factor in `up` is at most 2 * difference, that
                                  // of `up` L / h.
    out.lipschitz += size * 2 *
                     std::max(std::fabs(options.floor - options.wall),
                              std::fabs(options.ceiling - options.wall)) *
                     child.lipschitz / options.feel;
  if (options.by) out.lipschitz += size * factor * 0.5 * options.by->field.lipschitz();
  out.exactness = Exactness::sign;
  out.bounds = child.bounds_below(size * factor);
  out.growth = child.growth_rate();
  return out;
}

}  // namespace

NodePtr undisplaced(const Node& node) {
  const auto* displacement = dynamic_cast<const DisplaceNode*>(&node);
  return displacement ? displacement->child() : nullptr;
}

Field displaced(const Field& field, const Noise& noise, const Displacement& options) {
  if (options.amount == 0) return field;
  return Field(std::make_shared<DisplaceNode>(
      DisplaceNode::traits_of(field.node()->traits(), noise, options), field.node(), noise,
      options));
}

}  // namespace vug::field
