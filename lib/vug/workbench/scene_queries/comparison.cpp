// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string comparison_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  const PictureHistory& history = bench.history();
  return fmt::format("{} {} {}", history.shown(),
                     comparison_names()[static_cast<size_t>(history.comparison())],
                     history.reference());
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(comparison) {
  return {"comparison", "The shown picture, the comparison and the reference.", "", 0,
          comparison_of_scene};
}
