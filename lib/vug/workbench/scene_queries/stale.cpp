// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_stale(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.stale() ? "yes" : "no";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(stale) {
  return {"stale", "Whether the picture shows another text.", "", 0, scene_stale};
}
