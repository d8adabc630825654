// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void pan_scene(SceneBench& bench, const CommandCall& call) {
  viewport::Viewport& viewport = bench.viewport();
  viewport.set_view(
      viewport::pan(viewport.view(), parse_number(call.words[0]), parse_number(call.words[1])));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(pan) {
  return {.name = "pan",
          .title = "Pan",
          .doc = "Moves the view to the right and upwards, in units of the distance of its target.",
          .arguments = "RIGHT UP",
          .required = 2,
          .most = 2,
          .unavailable = without_picture,
          .run = pan_scene};
}
