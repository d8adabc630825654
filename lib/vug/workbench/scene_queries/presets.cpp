// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string presets_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  for (const Preset& each : bench.presets().all())
    out += (out.empty() ? "" : " ") + each.name + (each.locked ? "*" : "");
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(presets) {
  return {"presets", "The names of the presets; a locked one with *.", "", 0, presets_of_scene};
}
