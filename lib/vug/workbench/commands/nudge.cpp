// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

std::string nudge_unavailable(const FacadeBench& bench) {
  if (!bench.has_document()) return without_document(bench);
  return bench.handle() ? "" : "no handle is selected";
}

void run_nudge(FacadeBench& bench, const CommandCall& call) {
  const Handle handle = *bench.handle();
  const int node = numbers_node(bench.state(), bench.selected());
  const double to = handle.at + parse_length(call.words[0]);
  bench.edit(drag_edit(bench.state(), node, handle, to),
             fmt::format("nudge {} {}", bench.state().path(node), handle.index));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(nudge) {
  return {.name = "nudge",
          .title = "Nudge handle",
          .doc = "Moves the selected handle; repeated steps are one step of the history.",
          .arguments = "LENGTH",
          .changes = true,
          .required = 1,
          .most = 1,
          .unavailable = nudge_unavailable,
          .run = run_nudge};
}
