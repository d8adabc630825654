// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void pause_render_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.queue->pause(static_cast<int>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(pause_render) {
  return {.name = "pause_render",
          .title = "Pause a render",
          .doc = "Stops a render of the queue and keeps its checkpoint.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_renders,
          .run = pause_render_in_scene};
}
