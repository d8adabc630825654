// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

namespace vug::modeller {
namespace {

FacadeState run_join(const FacadeState& state, int node, const Edit&) {
  require_divided(state, node);
  facade::Plan plan = state.plan_of_node(node);
  if (!plan.apart) throw Error(ErrorCode::bad_input, "the node's parts have not been separated");
  plan.apart = false;
  FacadeState made = state.with(node, std::make_shared<const facade::Plan>(plan));
  // Decisions about the other instances are dropped.
  const int here = made.at(state.path_keys(node));
  std::map<facade::PartKey, facade::PlanPtr> parts;
  for (const int part : made.parts(here))
    if (const auto known = plan.parts.find(made.planned(part).place); known != plan.parts.end())
      parts.insert(*known);
  if (parts.size() == plan.parts.size()) return made;
  plan.parts = std::move(parts);
  return state.with(node, std::make_shared<const facade::Plan>(std::move(plan)));
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(join) {
  return {
      "join",
      "joins separated parts again; all become like the first one, on the left or at the bottom",
      false,
      false,
      {},
      run_join};
}
