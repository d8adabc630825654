// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_mode(const SceneBench& bench, const std::vector<std::string>&) {
  return viewport::mode_names().at(static_cast<size_t>(bench.viewport().request().mode));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(mode) { return {"mode", "The display mode of the picture.", "", 0, scene_mode}; }
