// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

std::string undo_unavailable(const FacadeBench& bench) {
  if (!bench.has_document()) return without_document(bench);
  return bench.stack().can_undo() ? "" : "there is nothing to undo";
}

void run_undo(FacadeBench& bench, const CommandCall& call) {
  const double steps = call.words.empty() ? 1 : parse_number(call.words[0]);
  for (double k = 0; k < steps && bench.undo(); ++k) {
  }
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(undo) {
  return {.name = "undo",
          .title = "Undo",
          .doc = "Undoes the last step, or several.",
          .arguments = "[STEPS]",
          .keys = "Ctrl+Z",
          .changes = true,
          .most = 1,
          .unavailable = undo_unavailable,
          .run = run_undo};
}
