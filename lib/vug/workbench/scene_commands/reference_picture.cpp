// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void reference_picture_in_scene(SceneBench& bench, const CommandCall& call) {
  PictureHistory& history = bench.history();
  history.set_reference(static_cast<int>(parse_number(call.words[0])));
  if (history.comparison() == ComparisonMode::off) history.compare(ComparisonMode::wipe);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(reference_picture) {
  return {.name = "reference_picture",
          .title = "Reference picture",
          .doc =
              "Compares with a kept picture by its number; 0: the picture of the present text. "
              "Begins with a wipe unless a comparison is shown.",
          .arguments = "NUMBER",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = reference_picture_in_scene};
}
