// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void end_scene_step(SceneBench& bench, const CommandCall&) { bench.end_step(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(end_step) {
  return {.name = "end_step",
          .title = "End step",
          .doc = "Ends the current undo step: the next change is a step of its own.",
          .changes = true,
          .most = 0,
          .unavailable = without_scene,
          .run = end_scene_step};
}
