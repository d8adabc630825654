// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void lock_preset_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.presets().lock(call.words[0], true);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(lock_preset) {
  return {.name = "lock_preset",
          .title = "Lock preset",
          .doc = "Protects a preset: it can be neither replaced nor deleted.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = lock_preset_in_scene};
}
