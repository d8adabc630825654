// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void pause_in_scene(SceneBench& bench, const CommandCall&) { bench.viewport().set_paused(true); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(pause) {
  return {.name = "pause",
          .title = "Pause",
          .doc =
              "Ends the refinement of the picture and keeps its samples; the pause ends with: "
              "continue.",
          .most = 0,
          .unavailable = without_scene,
          .run = pause_in_scene};
}
