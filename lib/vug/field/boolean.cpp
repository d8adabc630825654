// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/field/boolean.h>
#include <vug/field/constant.h>
#include <vug/field/fold_node.h>

#include <algorithm>
#include <utility>

namespace vug::field {
namespace {

/// Bounds of the inside; a blended union bulges by at most its depth at every fold.
Traits fold_traits(const OperandList& operands, double sign, const Blend& blend) {
  Traits traits;
  set_slope(traits, operands, blend);
  traits.bounds = sign > 0 ? Box3d() : infinite_box();
  const double bulge = sign > 0 ? blend.depth() * static_cast<double>(operands.size() - 1) : 0;
  int bounded = 0;
  traits.growth = 1;
  for (const Operand& operand : operands) {
    const Traits& t = operand.node->traits();
    if (operand.sign == sign) {
      const Box3d inside = t.bounds_below(bulge);
      traits.bounds =
          sign > 0 ? united(traits.bounds, inside) : intersection(traits.bounds, inside);
      if (is_finite(inside) || sign > 0) traits.growth = std::min(traits.growth, t.growth_rate());
      if (is_finite(inside)) ++bounded;
    } else if (sign > 0) {
      traits.bounds = infinite_box();
    }
  }
  // The distance to an intersection of boxes is at most sqrt(3) times the largest distance to one
  // of them.
  if (sign < 0 && bounded > 1) traits.growth *= traits.bounds.isEmpty() ? 0 : 0.57735;
  return traits;
}

Field fold(OperandList operands, double sign, const Blend& blend) {
  Traits traits = fold_traits(operands, sign, blend);
  auto node = std::make_shared<FoldNode>(std::move(traits), std::move(operands), sign, blend);
  node->group_operands();
  return Field(std::move(node));
}

std::vector<Operand> with_sign(const std::vector<Field>& fields, double sign) {
  std::vector<Operand> operands;
  for (const Field& f : fields) operands.emplace_back(f.node(), sign);
  return operands;
}

}  // namespace

Field unite(std::vector<Field> operands, const Blend& blend) {
  if (operands.empty()) return empty();
  if (operands.size() == 1) return operands[0];
  return fold(with_sign(operands, 1), 1, blend);
}

Field intersect(std::vector<Field> operands, const Blend& blend) {
  if (operands.empty())
    throw Error(ErrorCode::bad_input, "an intersection needs at least one operand");
  if (operands.size() == 1) return operands[0];
  return fold(with_sign(operands, -1), -1, blend);
}

Field subtract(Field base, std::vector<Field> cuts, const Blend& blend) {
  if (cuts.empty()) return base;
  std::vector<Operand> operands;
  operands.emplace_back(base.node(), -1);
  for (const Operand& cut : with_sign(cuts, 1)) operands.push_back(cut);
  return fold(std::move(operands), -1, blend);
}

Field symmetric_difference(const Field& a, const Field& b, const Blend& blend) {
  return subtract(unite({a, b}, blend), {intersect({a, b}, blend)}, blend);
}

Operands operands_of(const Node& node) {
  const auto* fold = dynamic_cast<const FoldNode*>(&node);
  return fold ? fold->operands() : Operands();
}

Field complement(const Field& a) {
  return fold(std::vector<Operand>{Operand(a.node(), 1)}, -1, {});
}

}  // namespace vug::field
