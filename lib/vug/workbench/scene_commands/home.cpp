// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void show_scene_camera(SceneBench& bench, const CommandCall&) { bench.viewport().set_view({}); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(home) {
  return {.name = "home",
          .title = "View of the camera",
          .doc = "Shows the view of the camera of the text.",
          .keys = "Home",
          .most = 0,
          .unavailable = without_scene,
          .run = show_scene_camera};
}
