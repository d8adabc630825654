// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string scene_built(const SceneBench& bench, const std::vector<std::string>&) {
  return fmt::format("{}", bench.status().counters.scenes);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(built) {
  return {"built", "Number of texts whose products were built.", "", 0, scene_built};
}
