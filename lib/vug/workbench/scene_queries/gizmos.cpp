// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string gizmos_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  for (const OverlayGizmo& each : bench.overlay().gizmos)
    out += (out.empty() ? "" : " ") + each.name + (each.selected ? "*" : "");
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(gizmos) {
  return {"gizmos", "The names of the lights and cameras that are marked in the picture.", "", 0,
          gizmos_of_scene};
}
