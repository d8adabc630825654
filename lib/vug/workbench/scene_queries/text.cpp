// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_text(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.text();
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(text) { return {"text", "The whole text.", "", 0, scene_text}; }
