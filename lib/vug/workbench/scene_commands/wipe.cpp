// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void wipe_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.history().set_edge(parse_number(call.words[0]));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(wipe) {
  return {.name = "wipe",
          .title = "Edge of the wipe",
          .doc = "Moves the edge of the wipe: 0 at the left, 1 at the right.",
          .arguments = "POSITION",
          .required = 1,
          .most = 1,
          .unavailable = without_scene,
          .run = wipe_in_scene};
}
