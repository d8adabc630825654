// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void write_scene_view(SceneBench& bench, const CommandCall&) { bench.write_view(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(write_view) {
  return {.name = "write_view",
          .title = "Write view to camera",
          .doc = "Writes the view into the camera of the text.",
          .keys = "Ctrl+Alt+C",
          .changes = true,
          .most = 0,
          .unavailable = without_picture,
          .run = write_scene_view};
}
