// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string wipe_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  return fmt::format("{:.2f}", bench.history().edge());
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(wipe) { return {"wipe", "The edge of the wipe.", "", 0, wipe_of_scene}; }
