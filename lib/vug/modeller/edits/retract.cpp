// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

namespace vug::modeller {
namespace {

FacadeState run_retract(const FacadeState& state, int node, const Edit&) {
  if (!state.planned(node).plan)
    throw Error(ErrorCode::bad_input, "there are no decisions about the node", {},
                "no rule divides it yet");
  return state.with(node, nullptr);
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(retract) {
  return {"retract", "removes the rule that divides a node, and everything below it",
          false,     false,
          {},        run_retract};
}
