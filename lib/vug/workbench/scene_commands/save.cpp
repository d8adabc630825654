// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void save_scene(SceneBench& bench, const CommandCall& call) {
  bench.save(call.words.empty() ? bench.file() : std::filesystem::path(call.words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(save) {
  return {.name = "save",
          .title = "Save",
          .doc = "Saves the text, to another file if one is named.",
          .arguments = "[FILE]",
          .keys = "Ctrl+S",
          .saves = true,
          .most = 1,
          .unavailable = without_scene,
          .run = save_scene};
}
