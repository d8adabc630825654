// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_checkpoint(FacadeBench& bench, const CommandCall& call) {
  bench.change_document(bench.document().with_checkpoint(call.words[0]),
                        "Set checkpoint " + call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(checkpoint) {
  return {.name = "checkpoint",
          .title = "Set checkpoint...",
          .doc = "Names the current state.",
          .arguments = "NAME",
          .keys = "Ctrl+K",
          .changes = true,
          .required = 1,
          .most = 1,
          .unavailable = without_document,
          .run = run_checkpoint};
}
