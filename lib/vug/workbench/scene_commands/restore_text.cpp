// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void restore_text_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.restore_text(static_cast<int>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(restore_text) {
  return {.name = "restore_text",
          .title = "Restore the text of a picture",
          .doc = "Replaces the text by that of a kept picture, as one step.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = restore_text_in_scene};
}
