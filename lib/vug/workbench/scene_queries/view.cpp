// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_view(const SceneBench& bench, const std::vector<std::string>&) {
  return viewport::camera_text(bench.viewport().view(), "view");
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(view) { return {"view", "The view as a camera.", "", 0, scene_view}; }
