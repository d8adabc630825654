// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string handle_of_scene(const SceneBench& bench, const std::vector<std::string>& words) {
  for (const OverlayHandle& each : bench.overlay().handles)
    if (each.name == words[0]) return fmt::format("{:.1f} {:.1f}", each.at.x, each.at.y);
  bench.handles().find(words[0]);
  return "behind the camera";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(handle) {
  return {"handle", "The position of a handle in pixels of the picture: X Y, with a decimal.",
          "NAME", 1, handle_of_scene};
}
