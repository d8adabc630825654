// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

std::string undo_scene_unavailable(const SceneBench& bench) {
  if (!bench.has_document()) return without_scene(bench);
  return bench.stack().can_undo() ? "" : "there is nothing to undo";
}

void undo_scene(SceneBench& bench, const CommandCall&) { bench.undo(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(undo) {
  return {.name = "undo",
          .title = "Undo",
          .doc = "Undoes the last change of the text.",
          .keys = "Ctrl+Z",
          .most = 0,
          .unavailable = undo_scene_unavailable,
          .run = undo_scene};
}
