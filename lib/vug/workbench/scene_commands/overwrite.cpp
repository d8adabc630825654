// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void overwrite_scene(SceneBench& bench, const CommandCall&) { bench.save(bench.file(), true); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(overwrite) {
  return {.name = "overwrite",
          .title = "Overwrite the file",
          .doc = "Saves the text, also if another program has changed the file.",
          .saves = true,
          .most = 0,
          .unavailable = without_scene,
          .run = overwrite_scene};
}
