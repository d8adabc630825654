// SPDX-License-Identifier: Apache-2.0
// Sets numbers. Lists whose length is a count are reset to their defaults when the count changes,
// unless they are set too.
#include <vug/modeller/plans.h>

#include <algorithm>

namespace vug::modeller {
namespace {

FacadeState run_set(const FacadeState& state, int node, const Edit& edit) {
  require_divided(state, node);
  if (edit.numbers.empty()) throw Error(ErrorCode::bad_input, "no number to set");
  facade::Plan plan = state.plan_of_node(node);
  for (const facade::FreeNumber& number : state.planned(node).free) {
    const auto count = edit.numbers.find(number.per);
    if (count == edit.numbers.end() || edit.numbers.count(number.name)) continue;
    const auto& all = state.planned(node).free;
    const auto before = std::find_if(all.begin(), all.end(), [&](const facade::FreeNumber& each) {
      return each.name == number.per;
    });
    if (before == all.end() || before->values != count->second) plan.numbers.erase(number.name);
  }
  plan.numbers = merged(std::move(plan.numbers), edit.numbers);
  return state.with(node, std::make_shared<const facade::Plan>(std::move(plan)));
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(set) {
  return {"set", "sets counts and sizes of a divided node; a name without a number resets it",
          false, true,
          {},    run_set};
}
