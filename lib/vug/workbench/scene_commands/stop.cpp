// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

std::string stop_scene_unavailable(const SceneBench& bench) {
  if (bench.has_document() && bench.viewport().request().region) return "";
  return bench.busy() ? "" : "nothing is being built";
}

void stop_scene(SceneBench& bench, const CommandCall&) {
  if (bench.viewport().request().region)
    bench.viewport().set_region(std::nullopt);
  else
    bench.viewport().stop();
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(stop) {
  return {
      .name = "stop",
      .title = "Stop",
      .doc =
          "Renders the whole picture after a region; else ends the work on the picture, and the "
          "last one stays.",
      .keys = "Esc",
      .most = 0,
      .unavailable = stop_scene_unavailable,
      .run = stop_scene};
}
