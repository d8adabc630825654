// SPDX-License-Identifier: Apache-2.0
// The names of nodes, edges and forms, and the sentence that explains a form.
#include <vug/drips/forms.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::drips {
namespace {

/// A number with commas between its thousands.
std::string grouped(double number) {
  std::string digits = fmt::format("{:.0f}", number);
  for (size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

/// Two significant digits.
double rounded(double number) {
  const double unit = std::pow(10.0, std::floor(std::log10(number)) - 1);
  return std::round(number / unit) * unit;
}

std::string interval_text(double seconds) {
  if (seconds < 10) return fmt::format("{:.1f} s a drop", seconds);
  return seconds < 600 ? fmt::format("{} s a drop", grouped(rounded(seconds)))
                       : fmt::format("{} min a drop", grouped(rounded(seconds / 60)));
}

constexpr const char* kNodes[] = {"seep", "confluence", "bend", "drop", "landing", "pool", "sink"};
constexpr const char* kEdges[] = {"ceiling_film", "wall_film", "fall", "floor_film", "overflow"};
constexpr const char* kNames[] = {"straw", "stalactite", "stalagmite", "column", "broken piece"};

}  // namespace

const char* kind_name(NodeKind kind) { return kNodes[static_cast<size_t>(kind)]; }
const char* kind_name(EdgeKind kind) { return kEdges[static_cast<size_t>(kind)]; }
const char* kind_name(FormKind kind) { return kNames[static_cast<size_t>(kind)]; }

std::string explain(const Form& form, size_t number, const Graph& graph) {
  const std::string on =
      form.plane < 0 ? "" : " on " + graph.planes[static_cast<size_t>(form.plane)];
  return fmt::format("{} {}: drip {}{}, {}, {} years", kind_name(form.kind), number, form.drip, on,
                     interval_text(form.interval), form.age > 0 ? grouped(rounded(form.age)) : "0");
}

}  // namespace vug::drips
