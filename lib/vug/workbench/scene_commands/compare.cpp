// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void compare_in_scene(SceneBench& bench, const CommandCall& call) {
  PictureHistory& history = bench.history();
  const auto next = static_cast<ComparisonMode>((static_cast<int>(history.comparison()) + 1) % 3);
  history.compare(call.words.empty() ? next : comparison_of(call.words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(compare) {
  return {.name = "compare",
          .title = "Compare",
          .doc =
              "Compares the shown picture with the reference: off, wipe or difference; without "
              "a word, the next one.",
          .arguments = "[off|wipe|difference]",
          .keys = "Ctrl+Alt+W",
          .most = 1,
          .unavailable = without_picture,
          .run = compare_in_scene};
}
