// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {

void expect(const SceneBench& bench, const std::vector<std::string>& words) {
  expect_in<SceneBench>(scene_queries(), bench, words);
}

}  // namespace vug::workbench
