// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void reload_scene(SceneBench& bench, const CommandCall&) { bench.reload(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(reload) {
  return {
      .name = "reload",
      .title = "Reload the file",
      .doc = "Takes the text of the file, which another program may have changed; undo returns.",
      .opens = true,
      .most = 0,
      .unavailable = without_scene,
      .run = reload_scene};
}
