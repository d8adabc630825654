// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

std::string fit_unavailable(const FacadeBench& bench) {
  return bench.fitting() ? "a fit is running" : without_photo(bench);
}

void run_fit(FacadeBench& bench, const CommandCall& call) {
  bench.start_fit(call.words.empty() ? 0 : static_cast<int64_t>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(fit) {
  return {.name = "fit",
          .title = "Fit to photo",
          .doc = "Finds the most likely tree for the photo; its result is one step.",
          .arguments = "[STEPS]",
          .keys = "F9",
          .most = 1,
          .unavailable = fit_unavailable,
          .run = run_fit};
}
