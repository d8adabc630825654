// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/workbench/scene_command.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

void region_in_scene(SceneBench& bench, const CommandCall& call) {
  if (call.words.empty()) return bench.viewport().set_region(std::nullopt);
  if (call.words.size() != 4)
    throw Error(ErrorCode::bad_input, "a region needs two corners", {},
                "such as: region 0.25 0.25 0.75 0.75");
  viewport::RegionBox box;
  double* const edges[] = {&box.x0, &box.y0, &box.x1, &box.y1};
  for (size_t i = 0; i < 4; ++i) {
    *edges[i] = parse_number(call.words[i]);
    if (!(*edges[i] >= 0 && *edges[i] <= 1))
      throw Error(ErrorCode::bad_input, "'" + call.words[i] + "' is outside of the picture", {},
                  "positions of the picture are from 0 to 1");
  }
  bench.viewport().set_region(box);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_COMMAND(region) {
  return {.name = "region",
          .title = "Whole picture",
          .doc =
              "Renders only the box between two corners, from 0 to 1; without corners, the whole "
              "picture again.",
          .arguments = "[X0 Y0 X1 Y1]",
          .most = 4,
          .unavailable = without_scene,
          .run = region_in_scene};
}
