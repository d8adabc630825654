// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_param(const SceneBench& bench, const std::vector<std::string>& words) {
  return bench.param(words[0]).text;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(param) {
  return {"param", "The value of a parameter as written in the text.", "NAME", 1, scene_param};
}
