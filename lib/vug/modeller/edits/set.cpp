// New numbers. Lists that a count is the length of are forgotten when it changes: they are as usual
// then, unless they are told too.
#include <vug/modeller/plans.h>

#include <algorithm>

namespace vug::modeller {
namespace {

FacadeState run(const FacadeState& state, int node, const Edit& edit) {
  require_divided(state, node);
  if (edit.numbers.empty()) throw Error(ErrorCode::bad_input, "there is no number to set");
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
  return {
      "set", "tells counts and sizes of a divided node; a name without a number is as usual again",
      false, true,
      {},    run};
}
