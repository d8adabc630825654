// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string handles_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return fmt::format("{}", bench.current_handles().size());
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(handles) {
  return {"handles", "Number of handles of the selected node.", "", 0, handles_value};
}
