// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_undo_name(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.stack().undo_name();
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(undo_name) {
  return {"undo_name", "Name of the step that undo takes back.", "", 0, scene_undo_name};
}
