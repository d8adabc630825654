// SPDX-License-Identifier: Apache-2.0
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

#include <fmt/format.h>

namespace vug::workbench {
namespace {

std::string width_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return fmt::format("{}", bench.state().canvas().width);
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(width) { return {"width", "Width of the facade in metres.", "", 0, width_value}; }
