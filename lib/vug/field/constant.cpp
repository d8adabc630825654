// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/constant.h>

namespace vug::field {
namespace {

/// Far, but not so far that single precision overflows in blends, morphs or squares.
constexpr double kFar = 1e6;

class ConstantNode final : public EvaluationModes<ConstantNode> {
 public:
  explicit ConstantNode(double value)
      : EvaluationModes({0, Exactness::bound, value > 0 ? Box3d() : infinite_box(), 1}),
        value_(value) {}
  template <class T>
  T at(const Point<T>&) const {
    return T(value_);
  }
  template <class T>
  void fill(const Point<Pack>*, int count, T* out, Scratch&) const {
    for (int i = 0; i < count; ++i) out[i] = T(value_);
  }
  NodePtr translated(const Vec3d&) const override { return std::make_shared<ConstantNode>(value_); }
  std::string name() const override { return value_ > 0 ? "empty" : "full"; }

 protected:
  void add_to(Digester& digester) const override { digester(value_); }

 private:
  double value_;
};

}  // namespace

Field constant_field(double value) { return Field(std::make_shared<ConstantNode>(value)); }

Field empty() {
  static const Field nothing = constant_field(kFar);
  return nothing;
}

Field::Field() : Field(empty()) {}

}  // namespace vug::field
