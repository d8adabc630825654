// SPDX-License-Identifier: Apache-2.0
#include <vug/facade/tree_output.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string state_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return facade::theta(bench.state().tree());
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(state) {
  return {"state", "Notation of the tree, as in ripperda2009.", "", 0, state_value};
}
