// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_adjust(FacadeBench& bench, const CommandCall& call) {
  modeller::Edit edit = modeller::parse_edit(call.rest, "set", bench.document().metres_per_pixel());
  std::string merge = "adjust " + edit.node;
  for (const auto& [name, values] : edit.numbers) merge += ' ' + name;
  bench.edit(edit, merge);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(adjust) {
  return {.name = "adjust",
          .title = "Adjust numbers",
          .doc =
              "Sets numbers of a node; repeated steps for the same numbers are one step of the "
              "history.",
          .arguments = "NODE NAME=N ...",
          .changes = true,
          .required = 2,
          .unavailable = without_document,
          .run = run_adjust};
}
