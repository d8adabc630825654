// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string size_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return fmt::format("{:.4g} x {:.4g}", bench.state().canvas().width,
                     bench.state().canvas().height);
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(size) { return {"size", "Width and height of the facade in metres.", "", 0, size_value}; }
