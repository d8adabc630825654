// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void show_picture_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.history().show(static_cast<int>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(show_picture) {
  return {.name = "show_picture",
          .title = "Show picture",
          .doc = "Shows a kept picture by its number; 0: the picture of the present text.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = show_picture_in_scene};
}
