// Where the areas of a tree lie, and whether everything fits into them.
#include <vug/fit/model/model.h>

#include <algorithm>

namespace vug::fit {
namespace {

/// A part of an area: from x on, in the area's own places and, if `again`, in those of its mirror
/// image or repetitions too.
struct Slice {
  int x = 0, width = 0, y = 0, height = 0;
};

/// Gives node `part` the area of the slices of `above`: each in all places of `above`. Those of odd
/// number are mirrored where `mirror` says so.
void cut(State& state, int part, const Area& above, const std::vector<Slice>& slices, bool mirror) {
  const Slice& first = slices.front();
  Area area;
  area.width = static_cast<int16_t>(first.width);
  area.height = static_cast<int16_t>(first.height);
  area.y = static_cast<int16_t>(above.y + first.y);
  area.first = static_cast<int32_t>(state.frames.size());
  area.count = static_cast<int16_t>(above.count * static_cast<int>(slices.size()));
  for (int place = 0; place < above.count; ++place) {
    const Frame frame = state.frame(above, place);
    for (size_t i = 0; i < slices.size(); ++i) {
      const int x = frame.mirrored ? above.width - slices[i].x - slices[i].width : slices[i].x;
      state.frames.push_back({static_cast<int16_t>(frame.x + x),
                              static_cast<bool>(frame.mirrored != (mirror && i % 2 == 1))});
    }
  }
  state.areas[static_cast<size_t>(part)] = area;
}

bool same_places(const Area& a, const std::vector<Frame>& frames_a, const Area& b,
                 const std::vector<Frame>& frames_b) {
  return a.width == b.width && a.height == b.height && a.y == b.y && a.count == b.count &&
         std::equal(frames_a.begin() + a.first, frames_a.begin() + a.first + a.count,
                    frames_b.begin() + b.first);
}

/// How wide the widest window of each line is.
using Sizes = std::array<int, kMostLines>;

/// Lines that begin at or after 0, are apart, end in time, and are even where they must be; unused
/// ones are 0.
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

bool Model::place(State& state) const {
  if (state.tree.size() > limits_.most_nodes) return false;
  thread_local std::vector<Frame> old_frames;
  thread_local std::vector<Area> old_areas;
  old_frames.swap(state.frames);
  old_areas = state.areas;
  state.frames.assign(1, Frame{});
  state.areas[0] = {static_cast<int16_t>(width_), static_cast<int16_t>(height_), 0, 1, 0};
  for (int i = 0; i < state.tree.size(); ++i) {
    const Area& area = state.area(i);
    if (area.width < limits_.least || area.height < limits_.least) return false;
    auto& known = state.known[static_cast<size_t>(i)];
    if (known && !same_places(old_areas[static_cast<size_t>(i)], old_frames, area, state.frames))
      known = 0;
    if (!known && !fits(state, i)) return false;
    if (!place_parts(state, i)) return false;
  }
  state.placed = true;
  return true;
}

bool Model::place_parts(State& state, int i) const {
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
      if (count < 2 || count > limits_.most_repeats || width < limits_.least) return false;
      std::vector<Slice> slices;
      for (int k = 0; k < count; ++k) slices.push_back({repeated_at(w, count, k), width, 0, h});
      cut(state, first, area, slices, false);
      return true;
    }
    case Op::mirror: {
      const bool has_middle = state.tree.end(first) < state.tree.end(i);
      const int middle = has_middle ? state.tree[state.tree.end(first)].extent : 0;
      const int side = (w - middle) / 2;
      if (side < limits_.least || (has_middle && (w - middle) % 2 != 0)) return false;
      cut(state, first, area, {{0, side, 0, h}, {w - side, side, 0, h}}, true);
      if (has_middle) cut(state, state.tree.end(first), area, {{side, middle, 0, h}}, false);
      return true;
    }
    case Op::elements: {
      int x = 0, count = 0;
      for (int part = first; part < state.tree.end(i); part = state.tree.end(part), ++count) {
        const bool last = state.tree.end(part) == state.tree.end(i);
        const int width = last ? w - x : state.tree[part].extent;
        if (width < limits_.least) return false;
        cut(state, part, area, {{x, width, 0, h}}, false);
        x += width;
      }
      return count <= limits_.most_elements;
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

bool Model::fits(const State& state, int i) const {
  const Node& node = state.tree[i];
  const Area& area = state.area(i);
  const SymbolInfo& symbol = rules_->symbol(node.symbol);
  if (symbol.terminal) {
    if (node.width < limits_.least || node.height < limits_.least) return false;
    // Where a grid's windows stand its lines say; a kind may stand nowhere.
    if (in_grid(node)) return node.width <= area.width && node.height <= area.height;
    return node.x >= 0 && node.y >= 0 && node.x + node.width <= area.width &&
           node.y + node.height <= area.height;
  }
  if (!symbol.grid) return true;
  if (node.columns < 1 || node.rows < 1 || node.columns > limits_.most_lines ||
      node.rows > limits_.most_lines)
    return false;
  Sizes widths, heights;
  widths.fill(limits_.least), heights.fill(limits_.least);
  const auto stands = [&](int column, int row, const Node& window) {
    int& width = widths[static_cast<size_t>(column)];
    int& height = heights[static_cast<size_t>(row)];
    width = std::max<int>(width, window.width), height = std::max<int>(height, window.height);
  };
  int kinds = 0;
  for (int part = i + 1; part < state.tree.end(i); ++part)
    kinds += rules_->symbol(state.tree[part].symbol).look == Look::window ? 1 : 0;
  if (kinds > (symbol.identical ? 1 : limits_.most_kinds)) return false;
  for (int row = 0; kinds > 0 && row < node.rows; ++row)
    for (int column = 0; column < node.columns; ++column) {
      const int kind = symbol.identical ? 1 : node.kind(column, row);
      if (kind > 0) stands(column, row, state.tree[i + kind]);
    }
  return lines_fit(node.left, node.columns, widths, columns_room(area), symbol.regular) &&
         lines_fit(node.top, node.rows, heights, area.height, symbol.regular);
}

}  // namespace vug::fit
