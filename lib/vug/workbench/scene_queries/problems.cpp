// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string scene_problems(const SceneBench& bench, const std::vector<std::string>&) {
  return fmt::format("{}", bench.status().problems->all().size());
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(problems) {
  return {"problems", "Number of problems of the text.", "", 0, scene_problems};
}
