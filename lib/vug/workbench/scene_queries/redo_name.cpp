// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_redo_name(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.stack().redo_name();
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(redo_name) {
  return {"redo_name", "Name of the step that redo performs.", "", 0, scene_redo_name};
}
