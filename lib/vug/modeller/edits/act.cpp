// SPDX-License-Identifier: Apache-2.0
// Actions: rules combined as in the modeller of ripperda2009 (section 5). The name of the symbol
// does not matter, and if a rule passes its rectangle to a symbol that only ends in elements, a
// rule of that symbol is applied as well.
#include <vug/modeller/plans.h>

#include <algorithm>

namespace vug::modeller {
namespace {

/// Rules of the symbol included in the action; a rule name selects that rule only.
std::vector<int> rules_of(const Style& style, const std::string& symbol, const std::string& name) {
  for (const Action& action : style.actions()) {
    if (action.name != name) continue;
    std::vector<int> out;
    for (const int rule : action.rules)
      if (style.rule(rule).head == symbol) out.push_back(rule);
    if (!out.empty()) return out;
  }
  return {style.find_rule(symbol, name)};
}

FacadeState run_act(const FacadeState& state, int node, const Edit& edit) {
  require_open(state, node);
  const Style& style = state.style();
  std::vector<facade::PlanPtr> plans;
  for (const int rule : rules_of(style, state.node(node).symbol, edit.rule)) {
    const std::optional<std::string> next = style.passes_to(rule);
    if (!next || !style.ends_in_elements(*next)) {
      plans.push_back(plan_of(rule, edit.numbers));
      continue;
    }
    for (const int follows : style.rules_of(*next)) {
      facade::Plan plan;
      plan.rule = rule;
      plan.parts[{}] = plan_of(follows, edit.numbers);
      plans.push_back(std::make_shared<const facade::Plan>(std::move(plan)));
    }
  }
  return first_feasible(state, node, plans);
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(act) {
  return {"act",
          "an action on an open node: a rule, and the next one if that only ends in elements; of "
          "several rules the first that accepts the numbers",
          true,
          true,
          {},
          run_act};
}
