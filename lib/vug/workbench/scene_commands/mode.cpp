// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void set_scene_mode(SceneBench& bench, const CommandCall& call) {
  bench.viewport().set_mode(viewport::mode_of(call.words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(mode) {
  return {.name = "mode",
          .title = "Mode",
          .doc = "Sets the display: clay, normals, ids, or path for the light of the scene.",
          .arguments = "NAME",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = set_scene_mode};
}
