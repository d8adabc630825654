// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void frame_scene(SceneBench& bench, const CommandCall&) {
  viewport::Viewport& viewport = bench.viewport();
  const viewport::PreviewPtr picture = viewport.status().picture;
  viewport.set_view(viewport::frame(viewport.view(), picture->scene.scene->bounds));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(frame) {
  return {.name = "frame",
          .title = "Show everything",
          .doc = "Moves the eye until the picture shows all objects.",
          .keys = "F",
          .most = 0,
          .unavailable = without_picture,
          .run = frame_scene};
}
