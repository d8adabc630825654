// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string render_error_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  if (bench.queue)
    for (const QueuedRender& each : bench.queue->all())
      if (each.state == RenderState::failed) out = each.error;
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(render_error) {
  return {"render_error", "The messages of the last render that failed.", "", 0,
          render_error_of_scene};
}
