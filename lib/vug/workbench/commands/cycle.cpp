// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/command.h>
#include <vug/workbench/facade_bench.h>

namespace vug::workbench {
namespace {

void run_cycle(FacadeBench& bench, const CommandCall& call) {
  const std::vector<Handle> all = bench.current_handles();
  if (all.empty())
    throw Error(ErrorCode::bad_input, "the selected node has no handles", {},
                "select a node whose numbers are free");
  const std::optional<Handle> now = bench.handle();
  const size_t count = all.size() / (all.back().instance + 1);
  const bool back = call.word(0) == "-1";
  const size_t next = !now ? (back ? count - 1 : 0) : (now->index + (back ? count - 1 : 1)) % count;
  bench.select_handle(next);
}

}  // namespace
}  // namespace vug::workbench

VUG_COMMAND(cycle) {
  return {.name = "cycle",
          .title = "Select next handle",
          .doc = "Selects the next or the previous handle of the selected node.",
          .arguments = "[-1]",
          .most = 1,
          .unavailable = without_document,
          .run = run_cycle};
}
