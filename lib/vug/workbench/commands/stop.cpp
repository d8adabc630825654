// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

std::string stop_unavailable(const FacadeBench& bench) {
  return bench.fitting() ? "" : "no fit is running";
}

void run_stop(FacadeBench& bench, const CommandCall&) { bench.stop_fit(); }

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(stop) {
  return {.name = "stop",
          .title = "Stop fit",
          .doc = "Ends the fit and takes its best tree.",
          .keys = "Shift+F9",
          .most = 0,
          .unavailable = stop_unavailable,
          .run = run_stop};
}
