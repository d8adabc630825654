// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void inspect_in_scene(SceneBench& bench, const CommandCall& call) {
  bench.inspect(parse_number(call.words[0]), parse_number(call.words[1]));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(inspect) {
  return {.name = "inspect",
          .title = "Inspect pixel",
          .doc =
              "Reads the values of the pixel at a position of the picture, 0..1, with its object "
              "and material.",
          .arguments = "X Y",
          .required = 2,
          .most = 2,
          .unavailable = without_picture,
          .run = inspect_in_scene};
}
