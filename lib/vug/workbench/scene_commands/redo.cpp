// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

std::string redo_scene_unavailable(const SceneBench& bench) {
  if (!bench.has_document()) return without_scene(bench);
  return bench.stack().can_redo() ? "" : "there is nothing to redo";
}

void redo_scene(SceneBench& bench, const CommandCall&) { bench.redo(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(redo) {
  return {.name = "redo",
          .title = "Redo",
          .doc = "Performs the last undone change again.",
          .keys = "Ctrl+Shift+Z",
          .most = 0,
          .unavailable = redo_scene_unavailable,
          .run = redo_scene};
}
