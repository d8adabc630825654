// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void save_preset_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.save_preset(call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(save_preset) {
  return {.name = "save_preset",
          .title = "Save preset...",
          .doc = "Keeps the values of all parameters under a name.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = save_preset_in_scene};
}
