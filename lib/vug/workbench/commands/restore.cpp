// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

std::string restore_unavailable(const FacadeBench& bench) {
  if (!bench.has_document()) return without_document(bench);
  return bench.document().checkpoints().empty() ? "the session has no checkpoints" : "";
}

void run_restore(FacadeBench& bench, const CommandCall& call) {
  const auto& all = bench.document().checkpoints();
  const auto found = all.find(call.words[0]);
  std::vector<std::string> names;
  for (const auto& [name, at] : all) names.push_back(name);
  if (found == all.end())
    throw Error(ErrorCode::bad_input, fmt::format("unknown checkpoint '{}'", call.words[0]), {},
                suggestion(call.words[0], names));
  bench.change_document(bench.document().first_edits(found->second),
                        "Restore checkpoint " + call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(restore) {
  return {.name = "restore",
          .title = "Restore checkpoint...",
          .doc = "Restores the state of a checkpoint.",
          .arguments = "NAME",
          .keys = "Ctrl+Shift+K",
          .changes = true,
          .required = 1,
          .most = 1,
          .unavailable = restore_unavailable,
          .run = run_restore};
}
