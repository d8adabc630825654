// SPDX-License-Identifier: Apache-2.0
#include <fmt/ranges.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string open_nodes_value(const FacadeBench& bench, const std::vector<std::string>&) {
  std::vector<std::string> out;
  for (const int node : bench.state().open()) out.push_back(bench.state().path(node));
  return fmt::format("{}", fmt::join(out, " "));
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(open_nodes) {
  return {"open_nodes", "Paths of the nodes that no rule divides.", "", 0, open_nodes_value};
}
