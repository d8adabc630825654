// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_save(FacadeBench& bench, const CommandCall& call) {
  if (call.words.empty() && bench.file().empty())
    throw Error(ErrorCode::bad_input, "the session has no file yet", {}, "save FILE");
  bench.save(call.words.empty() ? bench.file() : std::filesystem::path(call.words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(save) {
  return {.name = "save",
          .title = "Save",
          .doc = "Saves the session, to another file if one is named.",
          .arguments = "[FILE]",
          .keys = "Ctrl+S",
          .saves = true,
          .most = 1,
          .unavailable = without_document,
          .run = run_save};
}
