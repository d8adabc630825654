// SPDX-License-Identifier: Apache-2.0
#include <fmt/ranges.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>
#include <vug/workbench/specification.h>

namespace vug::workbench {
namespace {

std::string form_value(const FacadeBench& bench, const std::vector<std::string>&) {
  std::vector<std::string> out;
  for (const Field& each : specification(bench.state(), bench.selected()).fields)
    out.push_back(each.label);
  return fmt::format("{}", fmt::join(out, ", "));
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(form) { return {"form", "Labels of the fields of the form.", "", 0, form_value}; }
