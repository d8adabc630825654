// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

std::string stop_scene_unavailable(const SceneBench& bench) {
  return bench.busy() ? "" : "nothing is being built";
}

void stop_scene(SceneBench& bench, const CommandCall&) { bench.viewport().stop(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(stop) {
  return {.name = "stop",
          .title = "Stop",
          .doc = "Ends the work on the picture; the last one stays.",
          .keys = "Esc",
          .most = 0,
          .unavailable = stop_scene_unavailable,
          .run = stop_scene};
}
