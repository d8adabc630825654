// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void open_scene(SceneBench& bench, const CommandCall& call) {
  bench.open(call.words[0], call.words.size() > 1 ? std::optional(call.words[1]) : std::nullopt);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(open) {
  return {.name = "open",
          .title = "Open scene...",
          .doc = "Opens a scene; TEXT replaces the text of its file.",
          .arguments = "FILE [TEXT]",
          .keys = "Ctrl+O",
          .opens = true,
          .required = 1,
          .most = 2,
          .run = open_scene};
}
