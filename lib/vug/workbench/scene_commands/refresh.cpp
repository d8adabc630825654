// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void refresh_scene(SceneBench& bench, const CommandCall&) {
  if (bench.needs_build())
    bench.build();
  else
    bench.viewport().refresh();
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(refresh) {
  return {.name = "refresh",
          .title = "Build now",
          .doc = "Builds the text and its picture again.",
          .keys = "F5",
          .most = 0,
          .unavailable = without_scene,
          .run = refresh_scene};
}
