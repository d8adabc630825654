// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

namespace vug::modeller {
namespace {

using facade::Plan;

/// Keeps the plans of parts that exist under both rules: at the same positions, translated to the
/// symbols in `bare`, whose parts are undecided.
void keep_parts(const FacadeState& bare, int node, const Plan& old, Plan& plan) {
  for (const int part : bare.parts(node)) {
    const facade::PartKey& place = bare.planned(part).place;
    const auto known = old.parts.find(place);
    if (known == old.parts.end()) continue;
    if (auto kept = translated(bare.style(), known->second, bare.node(part).symbol))
      plan.parts[place] = kept;
  }
}

FacadeState run_change(const FacadeState& state, int node, const Edit& edit) {
  require_divided(state, node);
  if (node == FacadeState::kWhole || state.rule(node) < 0)
    throw edit_error("the node is part of a rule", "change the rule that divides its ancestor");
  const Plan& old = state.plan_of_node(node);
  const Style& style = state.style();
  Plan plan = old;
  plan.parts.clear();
  plan.numbers.clear();
  plan.rule = style.find_rule(state.node(node).symbol, edit.rule);
  if (plan.rule == old.rule)
    throw edit_error("that rule divides the node already", "use 'set' to change its numbers");
  const bool hands_on = style.passes_to(plan.rule).has_value();
  if (!hands_on) plan.numbers = merged(old.numbers, edit.numbers);

  const FacadeState bare = with_feasible_numbers(state, node, plan, edit.numbers);
  const int here = bare.at(state.path_keys(node));
  plan.numbers = bare.plan_of_node(here).numbers;
  keep_parts(bare, here, old, plan);
  if (hands_on && !edit.numbers.empty()) {
    if (plan.parts.empty())
      throw edit_error("no remaining part has free numbers", "omit the numbers");
    Plan part = *plan.parts.begin()->second;
    part.numbers = merged(part.numbers, edit.numbers);
    plan.parts.begin()->second = std::make_shared<const Plan>(std::move(part));
  }
  return with_feasible_numbers(state, node, std::move(plan), edit.numbers);
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(change) {
  return {"change",
          "replaces the rule that divides a node, for example by another type of grid; parts and "
          "numbers are kept as far as they fit",
          true,
          true,
          {},
          run_change};
}
