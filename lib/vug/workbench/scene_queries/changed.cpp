// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string changed_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  for (const language::ParamSetting& each : bench.params())
    if (bench.is_changed(each)) out += (out.empty() ? "" : " ") + each.name;
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(changed) {
  return {"changed", "The names of the parameters whose values differ from the saved text.", "", 0,
          changed_of_scene};
}
