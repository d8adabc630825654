// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_compare(FacadeBench& bench, const CommandCall& call) { bench.compare(call.words[0]); }

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(compare) {
  return {.name = "compare",
          .title = "Compare with session...",
          .doc = "Shows the scores of another session of the same facade.",
          .arguments = "FILE",
          .required = 1,
          .most = 1,
          .unavailable = without_document,
          .run = run_compare};
}
