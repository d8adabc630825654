// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_params(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  for (const language::ParamSetting& each : bench.params())
    out += (out.empty() ? "" : " ") + each.name;
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(params) { return {"params", "The names of the parameters.", "", 0, scene_params}; }
