// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void go_material_in_scene(SceneBench& bench, const CommandCall&) { bench.select_material(); }

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(go_material) {
  return {.name = "go_material",
          .title = "Go to material",
          .doc = "Selects the declaration of the material of the inspected pixel.",
          .most = 0,
          .unavailable = without_scene,
          .run = go_material_in_scene};
}
