// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/scene_query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string scene_problem(const SceneBench& bench, const std::vector<std::string>&) {
  const viewport::ViewportStatus status = bench.status();
  if (status.problems->all().empty()) return "";
  const Diagnostic& first = status.problems->all().front();
  return fmt::format("{}:{}: {}", first.where.line, first.where.column, first.message);
}

}  // namespace
}  // namespace vug::workbench

VUG_SCENE_QUERY(problem) {
  return {"problem", "The position and message of the first problem; empty without one.", "", 0,
          scene_problem};
}
