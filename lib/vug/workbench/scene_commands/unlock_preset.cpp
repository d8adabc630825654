// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void unlock_preset_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.presets().lock(call.words[0], false);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(unlock_preset) {
  return {.name = "unlock_preset",
          .title = "Unlock preset",
          .doc = "Ends the protection of a preset.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = unlock_preset_in_scene};
}
