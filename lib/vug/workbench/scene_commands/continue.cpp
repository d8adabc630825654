// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void continue_in_scene(SceneBench& bench, const CommandCall&) {
  bench.viewport().set_paused(false);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(continue) {
  return {.name = "continue",
          .title = "Continue",
          .doc = "Continues the refinement of the picture.",
          .most = 0,
          .unavailable = without_scene,
          .run = continue_in_scene};
}
