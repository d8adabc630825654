// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string region_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  if (!bench.has_document()) return "";
  const auto& box = bench.viewport().request().region;
  return box ? fmt::format("{:.2f} {:.2f} {:.2f} {:.2f}", box->x0, box->y0, box->x1, box->y1) : "";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(region) {
  return {"region", "The corners of the region that is rendered; empty: the whole picture.", "", 0,
          region_of_scene};
}
