// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void delete_preset_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.presets().remove(call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(delete_preset) {
  return {.name = "delete_preset",
          .title = "Delete preset",
          .doc = "Deletes a preset.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = delete_preset_in_scene};
}
