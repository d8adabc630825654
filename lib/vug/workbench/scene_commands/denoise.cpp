// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void denoise_in_scene(SceneBench& bench, const CommandCall& call) {
  viewport::DisplayChoice display = bench.viewport().request().display;
  const std::string word = call.word(0, display.denoise ? "off" : "on");
  if (word != "on" && word != "off")
    throw Error(ErrorCode::bad_input, "'" + word + "' is neither on nor off", {}, "denoise on");
  display.denoise = word == "on";
  bench.set_display(display);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(denoise) {
  return {.name = "denoise",
          .title = "Denoise",
          .doc =
              "Shows the light denoised in the display path: on or off; without a word, the other "
              "one.",
          .arguments = "[on|off]",
          .keys = "Ctrl+Alt+D",
          .most = 1,
          .unavailable = without_picture,
          .run = denoise_in_scene};
}
