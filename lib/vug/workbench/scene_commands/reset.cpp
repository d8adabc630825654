// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void reset_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.reset_param(call.words[0]);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(reset) {
  return {.name = "reset",
          .title = "Reset parameter",
          .doc = "Restores the value of a parameter in the saved text.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = reset_in_scene};
}
