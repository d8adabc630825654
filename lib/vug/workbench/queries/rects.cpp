// SPDX-License-Identifier: Apache-2.0
#include <fmt/ranges.h>
#include <vug/workbench/facade_bench.h>
#include <vug/workbench/query.h>

namespace vug::workbench {
namespace {

std::string rects_value(const FacadeBench& bench, const std::vector<std::string>& words) {
  std::vector<std::string> out;
  for (const Shape& each : shapes(bench.state()))
    if (each.symbol == words[0]) out.push_back(fmt::format("{:.4g}", each.rect.x));
  return fmt::format("{}", fmt::join(out, " "));
}

}  // namespace
}  // namespace vug::workbench

VUG_QUERY(rects) {
  return {"rects", "Left edges of all instances of an element, in metres.", "KIND", 1, rects_value};
}
