// SPDX-License-Identifier: Apache-2.0
#include <vug/field/material_mean.h>
#include <vug/field/material_source.h>

#include <algorithm>
#include <utility>

namespace vug::field {
namespace {

/// The mean changes by the whole range over a contact, whose distance is half the difference of two
/// values.
double contact_lipschitz(double mean_a, double mean_b, double value_slope,
                         const MaterialNumber& number) {
  return std::max(mean_a, mean_b) +
         number.range.width() * kContactSlope / number.contact * value_slope;
}

template <class T>
T limited(const T& value, const Interval& range) {
  return clamp(value, T(range.lo), T(range.hi));
}

/// Folds operands from left to right, as the union does.
class MeanNode final : public EvaluationModes<MeanNode> {
 public:
  MeanNode(Traits traits, std::vector<MeanOperand> operands, double sign, MaterialNumber number)
      : EvaluationModes(std::move(traits)),
        operands_(std::move(operands)),
        sign_(sign),
        number_(std::move(number)) {}

  template <class T>
  T at(const Point<T>& p) const {
    T least = operands_[0].solid.node()->eval(p) * T(sign_);
    T mean = operands_[0].mean.node()->eval(p);
    for (size_t i = 1; i < operands_.size(); ++i) {
      const T next = operands_[i].solid.node()->eval(p) * T(sign_);
      mean = mix(mean, operands_[i].mean.node()->eval(p), share(least, next));
      least = min(least, next);
    }
    return limited(mean, number_.range);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    Scratch::Frame frame(scratch);
    const auto size = static_cast<size_t>(count);
    T* least = frame.template take<T>(size);
    T* next = frame.template take<T>(size);
    T* mean = frame.template take<T>(size);
    operands_[0].solid.node()->eval(points, count, least, scratch);
    operands_[0].mean.node()->eval(points, count, out, scratch);
    for (int k = 0; k < count; ++k) least[k] = least[k] * T(sign_);
    for (size_t i = 1; i < operands_.size(); ++i) {
      operands_[i].solid.node()->eval(points, count, next, scratch);
      operands_[i].mean.node()->eval(points, count, mean, scratch);
      for (int k = 0; k < count; ++k) {
        next[k] = next[k] * T(sign_);
        out[k] = mix(out[k], mean[k], share(least[k], next[k]));
        least[k] = min(least[k], next[k]);
      }
    }
    for (int k = 0; k < count; ++k) out[k] = limited(out[k], number_.range);
  }
  Restriction restrict_to(const Ball& ball) const override {
    return {intersection(Node::restrict_to(ball).range, number_.range), nullptr};
  }
  std::string name() const override { return "mean of materials"; }
  std::vector<NodePtr> children() const override {
    std::vector<NodePtr> out;
    for (const MeanOperand& each : operands_)
      out.insert(out.end(), {each.solid.node(), each.mean.node()});
    return out;
  }

 protected:
  void add_to(Digester& digester) const override {
    digester(operands_, sign_, number_.range, number_.contact);
  }

 private:
  template <class T>
  T share(const T& least, const T& next) const {
    return share_inside((next - least) * T(0.5), number_.contact);
  }

  std::vector<MeanOperand> operands_;
  double sign_;
  MaterialNumber number_;
};

/// The solid of MeanOperand counts where it is negative: a fold with a solid of its negative value.
class OppositeNode final : public EvaluationModes<OppositeNode> {
 public:
  explicit OppositeNode(NodePtr child)
      : EvaluationModes({child->traits().lipschitz, Exactness::sign, infinite_box(), 0}),
        child_(std::move(child)) {}
  template <class T>
  T at(const Point<T>& p) const {
    return -child_->eval(p);
  }
  template <class T>
  void fill(const Point<Pack>* points, int count, T* out, Scratch& scratch) const {
    child_->eval(points, count, out, scratch);
    for (int k = 0; k < count; ++k) out[k] = -out[k];
  }
  std::string name() const override { return "outside"; }
  std::vector<NodePtr> children() const override { return {child_}; }

 protected:
  void add_to(Digester& digester) const override { digester(child_); }

 private:
  NodePtr child_;
};

}  // namespace

Field contact_mean(const std::vector<MeanOperand>& operands, double sign,
                   const MaterialNumber& number) {
  double slope = operands[0].mean.lipschitz(), values = operands[0].solid.lipschitz();
  for (size_t i = 1; i < operands.size(); ++i) {
    values = std::max(values, operands[i].solid.lipschitz());
    slope = contact_lipschitz(slope, operands[i].mean.lipschitz(), values, number);
  }
  if (operands.size() == 1) return operands[0].mean;
  return Field(std::make_shared<MeanNode>(Traits{slope, Exactness::sign, infinite_box(), 0},
                                          operands, sign, number));
}

Field contact_mean(const MeanOperand& body, const Field& outside, const MaterialNumber& number) {
  const Field rest(std::make_shared<OppositeNode>(body.solid.node()));
  return contact_mean({{rest, outside}, body}, 1, number);
}

std::optional<Field> material_mean(const Field& field, const MaterialNumber& number) {
  const auto* source = dynamic_cast<const MaterialSource*>(field.node().get());
  if (source) return source->material_mean(number);
  const std::vector<NodePtr> children = field.node()->children();
  if (children.empty()) return std::nullopt;
  return material_mean(Field(children.front()), number);
}

}  // namespace vug::field
