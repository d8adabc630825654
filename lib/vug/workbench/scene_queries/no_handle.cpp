// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string no_handle_of_scene(const SceneBench& bench, const std::vector<std::string>& words) {
  for (const language::MissingHandle& each : bench.handles().missing)
    if (each.name == words[0]) return each.reason;
  return "";
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(no_handle) {
  return {"no_handle", "The reason why a value has no handle; empty if it has one.", "NAME", 1,
          no_handle_of_scene};
}
