// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_differences(FacadeBench& bench, const CommandCall& call) {
  if (call.words.empty())
    bench.view().differences = !bench.view().differences;
  else if (call.words[0] == "on" || call.words[0] == "off")
    bench.view().differences = call.words[0] == "on";
  else
    throw Error(ErrorCode::bad_input, fmt::format("'{}' is neither on nor off", call.words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(differences) {
  return {.name = "differences",
          .title = "Mark differing pixels",
          .doc = "Marks the pixels that contradict the tree.",
          .arguments = "[on|off]",
          .keys = "D",
          .most = 1,
          .unavailable = without_photo,
          .run = run_differences};
}
