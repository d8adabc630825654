// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string score_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return bench.score() ? fmt::format("{:.4f}", bench.score()->score) : bench.score_reason();
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(score) { return {"score", "s(T), between 0 and 1.", "", 0, score_value}; }
