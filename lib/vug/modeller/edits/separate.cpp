// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

#include <algorithm>

namespace vug::modeller {
namespace {

FacadeState run_separate(const FacadeState& state, int node, const Edit&) {
  require_divided(state, node);
  const std::vector<int> parts = state.parts(node);
  if (std::all_of(parts.begin(), parts.end(),
                  [&](int part) { return state.node(part).copies.empty(); }))
    throw Error(ErrorCode::bad_input, "the node has no mirrored or repeated parts");
  facade::Plan plan = state.plan_of_node(node);
  plan.apart = true;
  const FacadeState apart = state.with(node, std::make_shared<const facade::Plan>(plan));
  // Each instance starts with the plan of the part that it copied.
  for (const int part : apart.parts(apart.at(state.path_keys(node)))) {
    const facade::PartKey place = apart.planned(part).place;
    const auto stamped = plan.parts.find({place.item, place.part, 0, 0});
    if (stamped != plan.parts.end()) plan.parts.try_emplace(place, stamped->second);
  }
  return state.with(node, std::make_shared<const facade::Plan>(std::move(plan)));
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(separate) {
  return {"separate", "breaks a symmetry: copies made by the node's split become separate parts",
          false,      false,
          {},         run_separate};
}
