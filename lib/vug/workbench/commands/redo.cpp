// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

std::string redo_unavailable(const FacadeBench& bench) {
  if (!bench.has_document()) return without_document(bench);
  return bench.stack().can_redo() ? "" : "there is nothing to redo";
}

void run_redo(FacadeBench& bench, const CommandCall& call) {
  const double steps = call.words.empty() ? 1 : parse_number(call.words[0]);
  for (double k = 0; k < steps && bench.redo(); ++k) {
  }
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(redo) {
  return {.name = "redo",
          .title = "Redo",
          .doc = "Performs the last undone step again, or several.",
          .arguments = "[STEPS]",
          .keys = "Ctrl+Shift+Z; Ctrl+Y",
          .changes = true,
          .most = 1,
          .unavailable = redo_unavailable,
          .run = run_redo};
}
