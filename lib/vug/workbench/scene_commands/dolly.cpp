// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void dolly_scene(SceneBench& bench, const CommandCall& call) {
  const double factor = parse_number(call.words[0]);
  if (!(factor > 0))
    throw Error(ErrorCode::bad_input, "the factor of dolly must be positive", {},
                "0.8 moves the eye nearer, 1.25 farther away");
  viewport::Viewport& viewport = bench.viewport();
  viewport.set_view(viewport::dolly(viewport.view(), factor));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(dolly) {
  return {.name = "dolly",
          .title = "Dolly",
          .doc = "Multiplies the distance of the eye from its target.",
          .arguments = "FACTOR",
          .required = 1,
          .most = 1,
          .unavailable = without_picture,
          .run = dolly_scene};
}
