// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void preset_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.apply_preset(call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(preset) {
  return {.name = "preset",
          .title = "Apply preset",
          .doc = "Sets all parameters of the text to the values of a preset, as one step.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = preset_in_scene};
}
