// SPDX-License-Identifier: Apache-2.0
#include <vug/field/blend.h>
#include <vug/field/boolean.h>
#include <vug/field/material_source.h>
#include <vug/field/translated.h>
#include <vug/field/variable_blend.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace vug::field {
namespace {

/// Radii below are sharp, because h divides by the radius.
constexpr double kSharp = 1e-6;

/// The radius relative to the middle of its range, so that its slope counts half of the range.
class RadiusNode final : public EvaluationModes<RadiusNode> {
 public:
  explicit RadiusNode(VariableRadius radius)
      : EvaluationModes({lipschitz_of(radius), Exactness::sign, infinite_box(), 0}),
        radius_(std::move(radius)) {}

  template <class T>
  T at(const Point<T>& p) const {
    T sum(0.0);
    for (const RadiusTerm& each : radius_.terms)
      sum = sum + each.weight.node()->eval(p) * (each.radius.node()->eval(p) - T(middle()));
    return limited(sum);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* weight = frame.template take<T>(static_cast<size_t>(count));
    T* radius = frame.template take<T>(static_cast<size_t>(count));
    for (int k = 0; k < count; ++k) out[k] = T(0.0);
    for (const RadiusTerm& each : radius_.terms) {
      each.weight.node()->eval(points, count, weight, scratch);
      each.radius.node()->eval(points, count, radius, scratch);
      for (int k = 0; k < count; ++k) out[k] = out[k] + weight[k] * (radius[k] - T(middle()));
    }
    for (int k = 0; k < count; ++k) out[k] = limited(out[k]);
  }
  Restriction restrict_to(const Ball& ball) const override {
    return {intersection(Node::restrict_to(ball).range, radius_.range), nullptr};
  }
  std::string name() const override { return "blend radius"; }
  std::vector<NodePtr> children() const override {
    std::vector<NodePtr> out;
    for (const RadiusTerm& each : radius_.terms)
      out.insert(out.end(), {each.weight.node(), each.radius.node()});
    return out;
  }

 protected:
  void add_to(Digester& digester) const override { digester(radius_); }

 private:
  double middle() const { return 0.5 * (radius_.range.lo + radius_.range.hi); }
  template <class T>
  T limited(const T& sum) const {
    return clamp(sum + T(middle()), T(radius_.range.lo), T(radius_.range.hi));
  }
  static double lipschitz_of(const VariableRadius& radius) {
    double weights = 0, radii = 0;
    for (const RadiusTerm& each : radius.terms) {
      weights += each.weight.lipschitz();
      radii = std::max(radii, each.radius.lipschitz());
    }
    return 0.5 * radius.range.width() * weights + radii;
  }

  VariableRadius radius_;
};

class VariableBlendNode final : public EvaluationModes<VariableBlendNode>, public MaterialSource {
 public:
  VariableBlendNode(Traits traits, NodePtr a, NodePtr b, NodePtr radius)
      : EvaluationModes(std::move(traits)),
        a_(std::move(a)),
        b_(std::move(b)),
        radius_(std::move(radius)) {}

  template <class T>
  T at(const Point<T>& p) const {
    return blended(a_->eval(p), b_->eval(p), radius_->eval(p));
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* other = frame.template take<T>(static_cast<size_t>(count));
    T* radius = frame.template take<T>(static_cast<size_t>(count));
    a_->eval(points, count, out, scratch);
    b_->eval(points, count, other, scratch);
    radius_->eval(points, count, radius, scratch);
    for (int k = 0; k < count; ++k) out[k] = blended(out[k], other[k], radius[k]);
  }
  Restriction restrict_to(const Ball& ball) const override {
    const Restriction a = a_->restrict_to(ball), b = b_->restrict_to(ball);
    const double reach = radius_->restrict_to(ball).range.hi;
    if (b.range.lo > a.range.hi + reach) return {a.range, a.node ? a.node : a_};
    if (a.range.lo > b.range.hi + reach) return {b.range, b.node ? b.node : b_};
    Restriction out;
    const Interval least = min(a.range, b.range);
    out.range = {least.lo - 0.25 * reach, least.hi};
    if (a.node || b.node)
      out.node = std::make_shared<VariableBlendNode>(traits(), a.node ? a.node : a_,
                                                     b.node ? b.node : b_, radius_);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    return std::make_shared<VariableBlendNode>(traits().translated(by), field::translated(a_, by),
                                               field::translated(b_, by),
                                               field::translated(radius_, by));
  }
  std::string name() const override { return "union"; }
  std::vector<NodePtr> children() const override { return {a_, b_, radius_}; }

  MaterialSample sample_materials(const Vec3d& p) const override {
    const MaterialSample a = field::sample_materials(*a_, p), b = field::sample_materials(*b_, p);
    const double radius = radius_->eval(point(p));
    const Blend blend{radius > kSharp ? Profile::smooth : Profile::sharp, radius};
    return {blended(a.value, b.value, radius), mixed(a.mix, b.mix, blend.share(a.value, b.value))};
  }
  Coat coat(const Vec3d& p) const override {
    return coat_at(a_->eval(point(p)) <= b_->eval(point(p)) ? *a_ : *b_, p);
  }
  std::optional<Field> material_mean(const MaterialNumber& number) const override {
    return field::material_mean(unite({Field(a_), Field(b_)}), number);
  }
  std::vector<NodePtr> material_operands() const override { return {a_, b_}; }

 protected:
  void add_to(Digester& digester) const override { digester(a_, b_, radius_); }

 private:
  template <class T>
  static T blended(const T& a, const T& b, const T& radius) {
    const T h = max(T(0.0), T(1.0) - abs(a - b) / max(radius, T(kSharp)));
    return min(a, b) - radius * square(h) * T(0.25);
  }

  NodePtr a_, b_, radius_;
};

}  // namespace

Field variable_blend(const Field& a, const Field& b, VariableRadius radius) {
  if (radius.terms.empty()) return unite({a, b}, {Profile::smooth, radius.range.lo});
  const double most = radius.range.hi;
  const auto k = std::make_shared<RadiusNode>(std::move(radius));
  Traits traits;
  traits.lipschitz = std::max(a.lipschitz(), b.lipschitz()) + 0.25 * k->traits().lipschitz;
  traits.exactness = Exactness::sign;
  const Traits &of_a = a.node()->traits(), &of_b = b.node()->traits();
  traits.bounds = united(of_a.bounds_below(0.25 * most), of_b.bounds_below(0.25 * most));
  traits.growth = std::min(of_a.growth_rate(), of_b.growth_rate());
  return Field(std::make_shared<VariableBlendNode>(std::move(traits), a.node(), b.node(), k));
}

}  // namespace vug::field
