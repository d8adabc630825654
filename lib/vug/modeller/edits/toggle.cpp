// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::modeller {
namespace {

int whole(const facade::Node& grid, const Edit& edit, const std::string& name,
          const std::string& counts) {
  double most = 0;
  for (const auto& [known, value] : grid.numbers)
    if (known == counts) most = value;
  const double value = edit.numbers.at(name)[0];
  if (value >= 0 && value < most && value == std::floor(value)) return static_cast<int>(value);
  throw facade::InfeasiblePlan(facade::Reason::does_not_fit, name,
                               fmt::format("no {} {}", name, value),
                               fmt::format("the grid has {} {}, counted from 0", most, counts));
}

FacadeState run_toggle(const FacadeState& state, int node, const Edit& edit) {
  require_divided(state, node);
  if (node == FacadeState::kWhole || state.node(node).split != "grid")
    throw Error(ErrorCode::bad_input, "the node is not divided by a grid");
  if (!has_cells(state, node))
    throw Error(ErrorCode::bad_input, "all cells of this grid are the same node", {},
                "change it to one that is not identical, or separate its cells");
  const std::pair<int, int> cell(whole(state.node(node), edit, "column", "columns"),
                                 whole(state.node(node), edit, "row", "rows"));
  facade::Plan plan = state.plan_of_node(node);
  if (!plan.off.erase(cell)) plan.off.insert(cell);
  FacadeState made = state.with(node, std::make_shared<const facade::Plan>(std::move(plan)));
  if (made.parts(made.at(state.path_keys(node))).empty())
    throw Error(ErrorCode::bad_input, "this is the last cell of the grid", {}, "retract the grid");
  return made;
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(toggle) {
  return {"toggle",
          "removes the content of one cell of a grid, or restores it",
          false,
          false,
          {"column", "row"},
          run_toggle};
}
