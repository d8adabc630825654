// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void resume_render_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.queue->resume(static_cast<int>(parse_number(call.words[0])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(resume_render) {
  return {.name = "resume_render",
          .title = "Resume a render",
          .doc = "Continues a paused or failed render of the queue.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_renders,
          .run = resume_render_in_scene};
}
