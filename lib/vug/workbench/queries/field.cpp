// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>
#include <vug/workbench/specification.h>

namespace vug::workbench {
namespace {

std::string field_value(const FacadeBench& bench, const std::vector<std::string>& words) {
  const Specification form = specification(bench.state(), bench.selected());
  return fmt::format("{:.6g}", find_field(form, words[0]).value);
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(field) { return {"field", "Value of a field of the form.", "LABEL", 1, field_value}; }
