// SPDX-License-Identifier: Apache-2.0
// The SG+M morph: a weighted sum of two unclipped fields (zawadzki2012, eq. 5).
#include <vug/field/boolean.h>
#include <vug/field/material_source.h>
#include <vug/field/translated.h>

namespace vug::field {
namespace {

Traits morph_traits(const Traits& a, const Traits& b, double amount) {
  // Where the sum is negative, at least one operand is.
  return {(1 - amount) * a.lipschitz + amount * b.lipschitz,
          std::max({a.exactness, b.exactness, Exactness::bound}), united(a.bounds, b.bounds),
          (1 - amount) * a.growth_rate() + amount * b.growth_rate()};
}

class MorphNode final : public EvaluationModes<MorphNode>, public MaterialSource {
 public:
  MorphNode(Traits traits, NodePtr a, NodePtr b, double amount)
      : EvaluationModes(std::move(traits)), a_(std::move(a)), b_(std::move(b)), amount_(amount) {}

  template <class T>
  T at(const Point<T>& p) const {
    return a_->eval(p) * (1 - amount_) + b_->eval(p) * amount_;
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    T* other = frame.template take<T>(static_cast<size_t>(count));
    a_->eval(points, count, out, scratch);
    b_->eval(points, count, other, scratch);
    for (int i = 0; i < count; ++i) out[i] = out[i] * (1 - amount_) + other[i] * amount_;
  }
  Restriction restrict_to(const Ball& ball) const override {
    Restriction a = a_->restrict_to(ball), b = b_->restrict_to(ball);
    const bool smaller = a.node || b.node;
    if (!a.node) a.node = a_;
    if (!b.node) b.node = b_;
    Restriction out;
    const Interval sum = a.range * Interval(1 - amount_) + b.range * Interval(amount_);
    out.range = sum;
    if (sum.width() >
        2.01 * traits().lipschitz * ball.radius) {  // The bound from the centre may be tighter.
      const Point<double> centre = point(ball.centre);
      const double value = a.node->eval(centre) * (1 - amount_) + b.node->eval(centre) * amount_;
      out.range = intersection(sum, centre_form(value, ball));
    }
    if (smaller)
      out.node =
          std::make_shared<MorphNode>(traits(), std::move(a.node), std::move(b.node), amount_);
    return out;
  }
  NodePtr translated(const Vec3d& by) const override {
    return std::make_shared<MorphNode>(traits().translated(by), field::translated(a_, by),
                                       field::translated(b_, by), amount_);
  }
  std::string name() const override { return "morph"; }
  std::vector<NodePtr> children() const override { return {a_, b_}; }

  MaterialSample sample_materials(const Vec3d& p) const override {
    const MaterialSample a = field::sample_materials(*a_, p), b = field::sample_materials(*b_, p);
    return {(1 - amount_) * a.value + amount_ * b.value, mixed(a.mix, b.mix, amount_)};
  }
  Coat coat(const Vec3d& p) const override { return coat_at(*a_, p); }
  std::optional<Field> material_mean(const MaterialNumber& number) const override {
    const std::optional<Field> a = field::material_mean(Field(a_), number),
                               b = field::material_mean(Field(b_), number);
    return a && b ? morph(*a, *b, amount_) : a ? a : b;
  }
  std::vector<NodePtr> material_operands() const override { return children(); }

 protected:
  void add_to(Digester& digester) const override { digester(a_, b_, amount_); }

 private:
  NodePtr a_, b_;
  double amount_;
};

}  // namespace

Field morph(const Field& a, const Field& b, double amount) {
  if (!(amount >= 0 && amount <= 1))
    throw Error(ErrorCode::bad_input, "a morph's amount must be between 0 and 1");
  if (amount == 0) return a;
  if (amount == 1) return b;
  return Field(std::make_shared<MorphNode>(
      morph_traits(a.node()->traits(), b.node()->traits(), amount), a.node(), b.node(), amount));
}

}  // namespace vug::field
