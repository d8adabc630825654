// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void gizmos_in_scene(SceneBench& bench, const CommandCall& call) {
  const std::string word = call.word(0, bench.shows_gizmos() ? "off" : "on");
  if (word != "on" && word != "off")
    throw Error(ErrorCode::bad_input, "'" + word + "' is neither on nor off", {}, "gizmos on");
  bench.show_gizmos(word == "on");
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(gizmos) {
  return {.name = "gizmos",
          .title = "Lights and cameras",
          .doc =
              "Shows or hides the symbols of lights and cameras: on or off; without a word, the "
              "other one.",
          .arguments = "[on|off]",
          .keys = "Ctrl+Alt+G",
          .most = 1,
          .unavailable = without_scene,
          .run = gizmos_in_scene};
}
