// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_open(FacadeBench& bench, const CommandCall& call) { bench.open(call.words[0]); }

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(open) {
  return {.name = "open",
          .title = "Open session...",
          .doc = "Opens a session.",
          .arguments = "FILE",
          .keys = "Ctrl+O",
          .opens = true,
          .required = 1,
          .most = 1,
          .run = run_open};
}
