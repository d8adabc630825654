// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string edits_value(const FacadeBench& bench, const std::vector<std::string>&) {
  return fmt::format("{}", bench.document().edit_count());
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(edits) { return {"edits", "Number of edits.", "", 0, edits_value}; }
