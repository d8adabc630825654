// SPDX-License-Identifier: Apache-2.0
// The node shared by offset, shell, complement and displacement, which modify a child's value at
// each point.
#pragma once

#include <vug/field/kind.h>
#include <vug/field/translated.h>

#include <algorithm>

namespace vug::field {

/// M has: template <class T> T apply(const T& value, const Point<T>& p) const
///        Traits traits(const Traits& child) const
///        Interval range(Interval child) const   (bounds of apply over all points, given the bounds
///        of the child)
template <class M>
class ModifierNode final : public EvaluationModes<ModifierNode<M>> {
 public:
  /// `origin`: the point at which `apply` is given p = 0.
  ModifierNode(std::string name, M modifier, NodePtr child, const Vec3d& origin = Vec3d(0))
      : EvaluationModes<ModifierNode<M>>(modifier.traits(child->traits())),
        name_(std::move(name)),
        modifier_(std::move(modifier)),
        child_(std::move(child)),
        origin_(origin) {
    // The parameters of a kind contain the field that it modifies. Restricted nodes have another
    // child, so only the child counts.
    if constexpr (requires { modifier_.field = Field(); }) modifier_.field = Field();
  }

  template <class T>
  T at(const Point<T>& p) const {
    return modifier_.apply(child_->eval(p), p - constant<T>(origin_));
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    child_->eval(points, count, out, scratch);
    const Point<Pack> origin = constant<Pack>(origin_);
    for (int i = 0; i < count; ++i)
      out[i] = modifier_.apply(out[i], point_for<T>(points[i] - origin));
  }

  Restriction restrict_to(const Ball& ball) const override {
    const Restriction inner = child_->restrict_to(ball);
    const double value = modifier_.apply(
        (inner.node ? inner.node : child_)->eval(point(ball.centre)), point(ball.centre - origin_));
    Restriction out;
    out.range = intersection(modifier_.range(inner.range), this->centre_form(value, ball));
    if (inner.node)
      out.node = std::make_shared<ModifierNode>(name_, modifier_, inner.node, origin_);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    return std::make_shared<ModifierNode>(name_, modifier_, field::translated(child_, by),
                                          origin_ + by);
  }
  std::string name() const override { return name_; }
  std::vector<NodePtr> children() const override { return {child_}; }

 protected:
  void add_to(Digester& digester) const override { digester(name_, modifier_, child_, origin_); }

 private:
  std::string name_;
  M modifier_;
  NodePtr child_;
  Vec3d origin_;
};

/// Traits of a modifier that cuts into its child. What it cuts has a slope of at most 1.
inline Traits carved_traits(const Traits& child) {
  Traits out = child;
  out.lipschitz = std::max(1.0, child.lipschitz);
  out.exactness = std::max(child.exactness, Exactness::bound);
  out.growth = child.growth_rate();
  return out;
}

/// What a modifier adds to its child, within `height` metres of it. Where it ends, the value is
/// divided by 1 + `slope`, and elsewhere its slope is at most 1.
struct GrownLayer {
  double height = 0, slope = 0;

  Traits traits(const Traits& child) const {
    Traits out = carved_traits(child);
    out.bounds = child.bounds_below(height);
    out.growth = child.growth_rate() / (1 + slope);
    return out;
  }
  Interval range(Interval child) const {
    const double beyond = child.lo - height;
    return {std::min(child.lo, beyond > 0 ? beyond / (1 + slope) : beyond), child.hi};
  }
};

}  // namespace vug::field
