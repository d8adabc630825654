// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/action_reason.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string reason_value(const FacadeBench& bench, const std::vector<std::string>& words) {
  for (const modeller::ActionChoice& each : modeller::actions(bench.state(), bench.selected()))
    if (each.action->name == words[0] || first_word(each.action->name) == words[0])
      return reason_text(each.choice);
  throw Error(ErrorCode::bad_input, fmt::format("the grammar has no action '{}'", words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(reason) {
  return {"reason", "Reason why an action is not available; empty if it is.", "ACTION", 1,
          reason_value};
}
