// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void keep_picture_in_scene(SceneBench& bench, const CommandCall&) {
  bench.history().keep(*bench.status().picture);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(keep_picture) {
  return {.name = "keep_picture",
          .title = "Keep this picture",
          .doc = "Keeps the picture with its text, view and display, for comparisons.",
          .keys = "Ctrl+Alt+K",
          .most = 0,
          .unavailable = without_picture,
          .run = keep_picture_in_scene};
}
