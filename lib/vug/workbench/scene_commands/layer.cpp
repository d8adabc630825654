// SPDX-License-Identifier: Apache-2.0
#include <vug/image/layers.h>
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void layer_in_scene(SceneBench& bench, const CommandCall& call) {
  viewport::DisplayChoice display = bench.viewport().request().display;
  display.layer = call.words[0] == image::kBeauty ? "" : call.words[0];
  bench.set_display(display);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(layer) {
  return {.name = "layer",
          .title = "Layer",
          .doc =
              "Shows a layer of the picture in the display path: beauty, or one of the layers of "
              "the render block, such as albedo or the light of a group.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_picture,
          .run = layer_in_scene};
}
