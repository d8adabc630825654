// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

#include <cmath>

namespace vug::workbench {
namespace {

void exposure_in_scene(SceneBench& bench, const CommandCall& call) {
  const double stops = parse_number(call.words[0]);
  if (!(std::abs(stops) <= 30))
    throw Error(ErrorCode::bad_input, "an exposure of '" + call.words[0] + "' stops is too large",
                {}, "use -30 to 30 stops");
  viewport::DisplayChoice display = bench.viewport().request().display;
  display.stops = stops;
  bench.set_display(display);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(exposure) {
  return {.name = "exposure",
          .title = "Exposure",
          .doc =
              "Sets the stops that are added to the exposure of the text in the display path; no "
              "ray is traced again.",
          .arguments = "STOPS",
          .required = 1,
          .most = 1,
          .unavailable = without_picture,
          .run = exposure_in_scene};
}
