// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/plans.h>

namespace vug::modeller {
namespace {

FacadeState run_apply(const FacadeState& state, int node, const Edit& edit) {
  require_open(state, node);
  const int rule = state.style().find_rule(state.node(node).symbol, edit.rule);
  return state.with(node, plan_of(rule, edit.numbers));
}

}  // namespace
}  // namespace vug::modeller

VUG_EDIT_KIND(apply) {
  return {"apply", "divides an open node by one rule; omitted numbers get their defaults",
          true,    true,
          {},      run_apply};
}
