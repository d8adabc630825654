// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string difference_of_scene(const SceneBench& bench, const std::vector<std::string>&) {
  return fmt::format("{:.6g}", bench.history().difference(bench.status().picture));
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(difference) {
  return {"difference", "The root mean square difference of the shown picture and the reference.",
          "", 0, difference_of_scene};
}
