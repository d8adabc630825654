// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string handles_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  std::string out;
  for (const language::LiteralHandle& each : bench.handles().handles)
    out += (out.empty() ? "" : " ") + each.name;
  return out;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(handles) {
  return {"handles", "The names of the handles of the statement at the caret.", "", 0,
          handles_of_scene};
}
