// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void cancel_render_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.queue->cancel(static_cast<int>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(cancel_render) {
  return {.name = "cancel_render",
          .title = "Cancel a render",
          .doc = "Removes a render and its checkpoint from the queue; a finished picture stays.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_renders,
          .run = cancel_render_in_scene};
}
