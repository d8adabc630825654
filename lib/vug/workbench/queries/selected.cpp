// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string selected_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return bench.state().path(bench.selected());
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(selected) { return {"selected", "Path of the selected node.", "", 0, selected_value}; }
