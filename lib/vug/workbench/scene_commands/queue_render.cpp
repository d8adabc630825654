// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

std::string no_queue(const SceneBench& bench) {
  return !bench.queue ? "this program has no queue" : without_scene(bench);
}

void queue_render_in_scene(SceneBench& bench, const CommandCall& call) {
  if (bench.is_modified())
    throw Error(ErrorCode::bad_input, "the queue renders the file, but the text is not saved", {},
                "save it first: save");
  QueuedRender render;
  render.scene = std::filesystem::absolute(bench.file());
  render.output = std::filesystem::absolute(call.words[0]);
  if (extension_of(render.output) != ".exr")
    throw Error(ErrorCode::bad_input,
                "a render is written to an .exr, not to '" + call.words[0] + "'", {},
                "such as: queue_render cave.exr");
  render.render = call.word(1);
  for (size_t i = 2; i < call.words.size(); ++i) {
    if (call.words[i].find('=') == std::string::npos)
      throw Error(ErrorCode::bad_input, "'" + call.words[i] + "' does not set a parameter", {},
                  "such as: RADIUS=40cm");
    render.parameters.push_back(call.words[i]);
  }
  bench.queue->add(std::move(render));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(queue_render) {
  return {.name = "queue_render",
          .title = "Queue a render...",
          .doc =
              "Adds a render of the saved scene to the queue: the file, the render block, and "
              "values of parameters.",
          .arguments = "OUTPUT [RENDER [PARAM=VALUE ...]]",
          .keys = "F6",
          .required = 1,
          .most = 100,
          .unavailable = no_queue,
          .run = queue_render_in_scene};
}
