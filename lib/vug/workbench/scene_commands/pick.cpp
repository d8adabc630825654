// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void pick_scene(SceneBench& bench, const CommandCall& call) {
  bench.pick(parse_number(call.words[0]), parse_number(call.words[1]));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(pick) {
  return {.name = "pick",
          .title = "Pick",
          .doc = "Selects the declaration of the object at a position of the picture, 0..1.",
          .arguments = "X Y",
          .required = 2,
          .most = 2,
          .unavailable = without_picture,
          .run = pick_scene};
}
