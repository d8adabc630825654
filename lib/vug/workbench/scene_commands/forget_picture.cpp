// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void forget_picture_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.history().forget(static_cast<int>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(forget_picture) {
  return {.name = "forget_picture",
          .title = "Forget picture",
          .doc = "Removes a kept picture.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = forget_picture_in_scene};
}
