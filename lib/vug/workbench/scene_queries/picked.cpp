// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_picked(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.picked() ? bench.picked()->object : "";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(picked) {
  return {"picked", "The name of the picked object; empty without one.", "", 0, scene_picked};
}
