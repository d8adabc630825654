// SPDX-License-Identifier: Apache-2.0
// Layout of a tree's areas and validation of its parameters.
#include <vug/fit/model/model.h>

#include <algorithm>

namespace vug::fit {
namespace {

/// A slice of an area: one for the part itself and, for mirrored or repeated parts, one for each
/// copy.
struct Slice {
  int x = 0, width = 0, y = 0, height = 0;
};

/// Gives node `part` the slices of `above`, each in all instances of `above`. Slices with an odd
/// index are mirrored if `mirror` is set.
void cut(TreeState& state, int part, const Area& above, const std::vector<Slice>& slices,
         bool mirror) {
  const Slice& first = slices.front();
  Area area;
  area.width = static_cast<int16_t>(first.width);
  area.height = static_cast<int16_t>(first.height);
  area.y = static_cast<int16_t>(above.y + first.y);
  area.first = static_cast<int32_t>(state.instances.size());
  area.count = static_cast<int16_t>(above.count * static_cast<int>(slices.size()));
  for (int place = 0; place < above.count; ++place) {
    const AreaInstance instance = state.instance(above, place);
    for (size_t i = 0; i < slices.size(); ++i) {
      const int x = instance.mirrored ? above.width - slices[i].x - slices[i].width : slices[i].x;
      state.instances.push_back({static_cast<int16_t>(instance.x + x),
                                 static_cast<bool>(instance.mirrored != (mirror && i % 2 == 1))});
    }
  }
  state.areas[static_cast<size_t>(part)] = area;
}

bool same_places(const Area& a, const std::vector<AreaInstance>& instances_a, const Area& b,
                 const std::vector<AreaInstance>& instances_b) {
  return a.width == b.width && a.height == b.height && a.y == b.y && a.count == b.count &&
         std::equal(instances_a.begin() + a.first, instances_a.begin() + a.first + a.count,
                    instances_b.begin() + b.first);
}

/// Width of the widest window of each line.
using Sizes = std::array<int, kMaxLines>;

/// Whether the lines start at 0 or later, do not touch, end within the room, and are even if
/// `regular`; unused lines must be 0.
bool lines_fit(const Lines& lines, int count, const Sizes& sizes, int room, bool regular) {
  for (int i = 0; i < count; ++i) {
    const auto at = static_cast<size_t>(i);
    const int end = i + 1 < count ? lines[at + 1] - 1 : room;
    if (lines[at] < 0 || lines[at] + sizes[at] > end) return false;
  }
  const int span = lines[static_cast<size_t>(count - 1)] - lines[0];
  return !regular || lines == even_lines(lines[0], span, count);
}

}  // namespace

bool Model::compute_areas(TreeState& state) const {
  if (state.tree.size() > limits_.max_nodes) return false;
  thread_local std::vector<AreaInstance> old_instances;
  thread_local std::vector<Area> old_areas;
  old_instances.swap(state.instances);
  old_areas = state.areas;
  state.instances.assign(1, AreaInstance{});
  state.areas[0] = {static_cast<int16_t>(width_), static_cast<int16_t>(height_), 0, 1, 0};
  for (int i = 0; i < state.tree.size(); ++i) {
    const Area& area = state.area(i);
    if (area.width < limits_.min_size || area.height < limits_.min_size) return false;
    auto& known = state.bits_valid[static_cast<size_t>(i)];
    if (known &&
        !same_places(old_areas[static_cast<size_t>(i)], old_instances, area, state.instances))
      known = 0;
    if (!known && !fits(state, i)) return false;
    if (!compute_child_areas(state, i)) return false;
  }
  state.areas_valid = true;
  return true;
}

bool Model::compute_child_areas(TreeState& state, int i) const {
  const Node& node = state.tree[i];
  if (node.production < 0) return true;
  const Area area = state.area(i);
  const int first = i + 1, w = area.width, h = area.height;
  switch (rules_->production(node.production).op) {
    case Op::rows: {
      const int row = state.tree[first].extent;
      cut(state, first, area, {{0, w, h - row, row}}, false);
      cut(state, state.tree.end(first), area, {{0, w, 0, h - row}}, false);
      return row < h;
    }
    case Op::repeat: {
      const int count = state.tree[first].extent, width = w / count;
      if (count < 2 || count > limits_.max_repeats || width < limits_.min_size) return false;
      std::vector<Slice> slices;
      for (int k = 0; k < count; ++k)
        slices.push_back({repetition_offset(w, count, k), width, 0, h});
      cut(state, first, area, slices, false);
      return true;
    }
    case Op::mirror: {
      const bool has_middle = state.tree.end(first) < state.tree.end(i);
      const int middle = has_middle ? state.tree[state.tree.end(first)].extent : 0;
      const int side = (w - middle) / 2;
      if (side < limits_.min_size || (has_middle && (w - middle) % 2 != 0)) return false;
      cut(state, first, area, {{0, side, 0, h}, {w - side, side, 0, h}}, true);
      if (has_middle) cut(state, state.tree.end(first), area, {{side, middle, 0, h}}, false);
      return true;
    }
    case Op::elements: {
      int x = 0, count = 0;
      for (int part = first; part < state.tree.end(i); part = state.tree.end(part), ++count) {
        const bool last = state.tree.end(part) == state.tree.end(i);
        const int width = last ? w - x : state.tree[part].extent;
        if (width < limits_.min_size) return false;
        cut(state, part, area, {{x, width, 0, h}}, false);
        x += width;
      }
      return count <= limits_.max_elements;
    }
    case Op::grid:
    case Op::windows:
    case Op::terminal:
      for (int part = first; part < state.tree.end(i); part = state.tree.end(part))
        state.areas[static_cast<size_t>(part)] = area;
      return true;
  }
  return false;
}

bool Model::admits(RegionType type, const Area& area, const Rect& rect) const {
  if (type != RegionType::door && type != RegionType::shop) return true;
  return height_ - (area.y + rect.y1) <= limits_.max_sill &&
         (type == RegionType::shop || rect.y1 - rect.y0 <= limits_.max_door_height);
}

bool Model::fits(const TreeState& state, int i) const {
  const Node& node = state.tree[i];
  const Area& area = state.area(i);
  const SymbolInfo& symbol = rules_->symbol(node.symbol);
  if (symbol.terminal) {
    if (node.width < limits_.min_size || node.height < limits_.min_size) return false;
    // Windows of a grid are positioned by its lines; a kind may have no instance.
    if (in_grid(node)) return node.width <= area.width && node.height <= area.height;
    return node.x >= 0 && node.y >= 0 && node.x + node.width <= area.width &&
           node.y + node.height <= area.height && admits(symbol.type, area, rect_of(node));
  }
  if (!symbol.grid) return true;
  if (node.columns < 1 || node.rows < 1 || node.columns > limits_.max_lines ||
      node.rows > limits_.max_lines)
    return false;
  Sizes widths, heights;
  widths.fill(limits_.min_size), heights.fill(limits_.min_size);
  const auto stands = [&](int column, int row, const Node& window) {
    int& width = widths[static_cast<size_t>(column)];
    int& height = heights[static_cast<size_t>(row)];
    width = std::max<int>(width, window.width), height = std::max<int>(height, window.height);
  };
  int kinds = 0;
  for (int part = i + 1; part < state.tree.end(i); ++part)
    kinds += rules_->symbol(state.tree[part].symbol).type == RegionType::window ? 1 : 0;
  if (kinds > (symbol.identical ? 1 : limits_.max_kinds)) return false;
  for (int row = 0; kinds > 0 && row < node.rows; ++row)
    for (int column = 0; column < node.columns; ++column) {
      const int kind = symbol.identical ? 1 : node.kind(column, row);
      if (kind > 0) stands(column, row, state.tree[i + kind]);
    }
  return lines_fit(node.left, node.columns, widths, usable_width(area), symbol.regular) &&
         lines_fit(node.top, node.rows, heights, area.height, symbol.regular);
}

}  // namespace vug::fit
