// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_dirty(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.has_document() && bench.is_modified() ? "yes" : "no";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(dirty) {
  return {"dirty", "Whether the text differs from its file.", "", 0, scene_dirty};
}
