// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/lines.h>
#include <vug/modeller/plans.h>

#include <fmt/format.h>

namespace vug::modeller {
namespace {

FacadeState run_move(const FacadeState& state, int node, const Edit& edit) {
  require_divided(state, node);
  const std::vector<Line> all = lines(state, node);
  const double number = edit.numbers.at("line")[0];
  if (!(number >= 0) || number >= static_cast<double>(all.size()) || number != std::floor(number))
    throw facade::InfeasiblePlan(
        facade::Reason::does_not_fit, "line", fmt::format("no line {}", number),
        all.empty() ? "the rule fixes the positions of its lines"
                    : fmt::format("it has {} lines, counted from 0", all.size()));
  facade::Plan plan = state.plan_of_node(node);
  const facade::NumberValues numbers =
      move_line(state, node, all[static_cast<size_t>(number)], edit.numbers.at("to")[0]);
  plan.numbers = merged(std::move(plan.numbers), numbers);
  return state.with(node, std::make_shared<const facade::Plan>(std::move(plan)));
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(move) {
  return {
      "move",         "moves a line between two parts, or the start of a column or row of a grid",
      false,          false,
      {"line", "to"}, run_move};
}
