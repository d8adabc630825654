// SPDX-License-Identifier: Apache-2.0
#include <vug/modeller/lines.h>

#include <algorithm>

namespace vug::modeller {

namespace {

using facade::FreeNumber;

/// Names of a grid's numbers along x and y.
struct Axis {
  const char *start, *pitch, *count;
};
constexpr Axis kAxes[] = {{"x", "dx", "columns"}, {"y", "dy", "rows"}};

const FreeNumber* number(const FacadeState& state, int node, const std::string& name) {
  for (const FreeNumber& each : state.planned(node).free)
    if (each.name == name) return &each;
  return nullptr;
}

double extent(const FacadeState& state, int node, bool upright) {
  if (node == FacadeState::kWhole) return upright ? state.canvas().width : state.canvas().height;
  return upright ? state.node(node).rect.width : state.node(node).rect.height;
}

/// Adds the lines between parts of these sizes, centred in the gaps between the parts.
void add_split_lines(const FacadeState& state, int node, const FreeNumber& sizes, bool upright,
                     std::vector<Line>& out) {
  double total = 0, at = 0;
  for (const double size : sizes.values) total += size;
  const size_t gaps = sizes.values.size() - 1;
  const double gap =
      gaps == 0 ? 0
                : std::max(0.0, extent(state, node, upright) - total) / static_cast<double>(gaps);
  for (size_t i = 0; i < gaps; ++i) {
    at += sizes.values[i];
    out.push_back({upright, at + gap / 2, sizes.name, i});
    at += gap;
  }
}

/// Starts of columns or rows; empty if the text fixes them.
std::vector<double> starts(const FacadeState& state, int node, const Axis& axis) {
  const FreeNumber* first = number(state, node, axis.start);
  const FreeNumber* count = number(state, node, axis.count);
  if (!first || !count) return {};
  const FreeNumber* pitch = number(state, node, axis.pitch);
  std::vector<double> out = {first->values[0]};
  for (size_t i = 0; i + 1 < static_cast<size_t>(count->values[0]) && pitch; ++i)
    out.push_back(out.back() + pitch->values[std::min(i, pitch->values.size() - 1)]);
  return out;
}

}  // namespace

std::vector<Line> lines(const FacadeState& state, int node) {
  std::vector<Line> out;
  for (const FreeNumber& each : state.planned(node).free) {
    const std::string plain = each.name.substr(each.name.find('.') + 1);
    if (plain == "widths" || plain == "heights")
      add_split_lines(state, node, each, plain == "widths", out);
  }
  const FreeNumber* middle = number(state, node, "width");
  if (node != FacadeState::kWhole && state.node(node).split == "mirror" && middle) {
    const double side = (extent(state, node, true) - middle->values[0]) / 2;
    out.push_back({true, side, "width", 0});
    out.push_back({true, side + middle->values[0], "width", 1});
  }
  for (const Axis& axis : kAxes) {
    const std::vector<double> all = starts(state, node, axis);
    for (size_t i = 0; i < all.size(); ++i)
      out.push_back({&axis == &kAxes[0], all[i], i == 0 ? axis.start : axis.pitch, i});
  }
  return out;
}

facade::NumberValues move_line(const FacadeState& state, int node, const Line& line, double to) {
  const double by = to - line.at;
  if (line.number == "width") {
    const double whole = extent(state, node, true);
    return {{"width", {line.index == 0 ? whole - 2 * to : 2 * to - whole}}};
  }
  if (number(state, node, line.number) && line.number.ends_with("s")) {
    std::vector<double> sizes = number(state, node, line.number)->values;
    sizes[line.index] += by;
    sizes[line.index + 1] -= by;
    return {{line.number, sizes}};
  }
  const Axis& axis = kAxes[line.upright ? 0 : 1];
  std::vector<double> all = starts(state, node, axis);
  const FreeNumber* pitch = number(state, node, axis.pitch);
  const bool regular = pitch && pitch->per.empty();
  facade::NumberValues out = {{axis.start, {all[0]}}};
  if (!pitch) {
    out[axis.start] = {to};
    return out;
  }
  if (regular) {
    if (line.index == 0) out[axis.start] = {to};
    out[axis.pitch] = line.index == 0
                          ? pitch->values
                          : std::vector{(to - all[0]) / static_cast<double>(line.index)};
    return out;
  }
  all[line.index] = to;
  std::vector<double> pitches;
  for (size_t i = 1; i < all.size(); ++i) pitches.push_back(all[i] - all[i - 1]);
  out[axis.start] = {all[0]};
  out[axis.pitch] = pitches;
  return out;
}

}  // namespace vug::modeller
