// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

bool is_relative(const std::string& word) {
  return word == "parent" || word == "child" || word == "next" || word == "previous" ||
         word == "open";
}

void run_select(FacadeBench& bench, const CommandCall& call) {
  const std::string& word = call.words[0];
  bench.select(is_relative(word) ? relative(bench.state(), bench.selected(), word)
                                 : bench.state().find(word));
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(select) {
  return {
      .name = "select",
      .title = "Select",
      .doc = "Selects a node by its path, or a relative: parent, child, next, previous or open.",
      .arguments = "NODE",
      .changes = true,
      .required = 1,
      .most = 1,
      .unavailable = without_document,
      .run = run_select};
}
