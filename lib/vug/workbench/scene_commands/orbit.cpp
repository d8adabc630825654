// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

double degrees(const std::string& word) { return parse_number(word) * kPi / 180; }

void orbit_scene(SceneBench& bench, const CommandCall& call) {
  viewport::Viewport& viewport = bench.viewport();
  viewport.set_view(
      viewport::orbit(viewport.view(), degrees(call.words[0]), degrees(call.word(1, "0"))));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(orbit) {
  return {.name = "orbit",
          .title = "Orbit",
          .doc = "Turns the view around its target by angles in degrees.",
          .arguments = "YAW [PITCH]",
          .required = 1,
          .most = 2,
          .unavailable = without_picture,
          .run = orbit_scene};
}
