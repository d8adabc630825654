// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_replace(FacadeBench& bench, const CommandCall& call) {
  std::vector<modeller::Edit> edits;
  for (size_t i = 1; i < call.words.size(); ++i)
    edits.push_back(modeller::parse_edit(call.words[i]));
  bench.replace(edits, call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(replace) {
  return {.name = "replace",
          .title = "Replace all edits",
          .doc = "Makes these edits the only ones, as one step.",
          .arguments = "STEP EDIT...",
          .changes = true,
          .required = 1,
          .most = 100000,
          .unavailable = without_document,
          .run = run_replace};
}
