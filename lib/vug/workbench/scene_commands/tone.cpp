// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void tone_in_scene(SceneBench& bench, const CommandCall& call) {
  viewport::DisplayChoice display = bench.viewport().request().display;
  display.view = call.words[0] == "scene" ? "" : call.words[0];
  bench.set_display(display);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(tone) {
  return {.name = "tone",
          .title = "View transform",
          .doc =
              "Sets the view transform of the display path: filmic, standard, aces or another of "
              "the configuration; scene: that of the text.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_picture,
          .run = tone_in_scene};
}
