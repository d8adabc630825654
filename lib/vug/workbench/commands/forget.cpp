// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_forget(FacadeBench& bench, const CommandCall&) { bench.clear_comparisons(); }

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(forget) {
  return {.name = "forget",
          .title = "End comparison",
          .doc = "Removes all compared sessions.",
          .most = 0,
          .run = run_forget};
}
