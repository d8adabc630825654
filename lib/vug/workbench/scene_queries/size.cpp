// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string scene_size(const SceneBench& bench, const std::vector<std::string>&) {
  const viewport::PreviewPtr picture = bench.status().picture;
  return picture ? fmt::format("{} x {}", picture->width, picture->height) : "";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(size) {
  return {"size", "Width and height of the picture in pixels.", "", 0, scene_size};
}
