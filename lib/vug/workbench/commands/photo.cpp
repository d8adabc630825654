// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void run_photo(FacadeBench& bench, const CommandCall& call) {
  const double width = call.words.size() > 1 ? parse_length(call.words[1]) : session::kDefaultWidth;
  bench.open_photo(call.words[0], call.word(2, "ripperda.vug"), width);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(photo) {
  return {.name = "photo",
          .title = "Open photo...",
          .doc = "Begins a session over a photo of an upright facade.",
          .arguments = "FILE [WIDTH] [GRAMMAR]",
          .keys = "Ctrl+N",
          .opens = true,
          .required = 1,
          .most = 3,
          .run = run_photo};
}
