// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string complexity_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return bench.score() ? fmt::format("{:.0f}", bench.score()->complexity) : bench.score_reason();
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(complexity) {
  return {"complexity", "c(T) in bits, without decimals.", "", 0, complexity_value};
}
