// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

namespace vug::workbench {
namespace {

std::string scene_report(const SceneBench& bench, const std::vector<std::string>&) {
  return bench.status().report;
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(report) {
  return {"report", "The problems with their lines, as vug check prints them.", "", 0,
          scene_report};
}
