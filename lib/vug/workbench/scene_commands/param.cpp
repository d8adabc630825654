// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>

namespace vug::workbench {
namespace {

void set_scene_param(SceneBench& bench, const CommandCall& call) {
  bench.set_param(call.words[0], call.words[1], call.word(2));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(param) {
  return {.name = "param",
          .title = "Set parameter",
          .doc =
              "Writes the value of a parameter into the text; changes with the same MERGE are "
              "one step.",
          .arguments = "NAME VALUE [MERGE]",
          .changes = true,
          .required = 2,
          .most = 3,
          .unavailable = without_scene,
          .run = set_scene_param};
}
