// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string inspected_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.inspected() ? viewport::describe(*bench.inspected()) : "";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(inspected) {
  return {"inspected", "The values of the inspected pixel; empty without one.", "", 0,
          inspected_of_scene};
}
