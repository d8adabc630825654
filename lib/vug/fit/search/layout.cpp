// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/search/layout.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace vug::fit {
namespace {

/// Prefix sums of the gain along one axis, over the segments of the other one; without segments
/// over the whole axis minus the mean, which shows where windows are possible at all.
std::vector<double> before(const FoldedIntegral& integral, bool along_x,
                           const std::vector<Segment>& across) {
  const int room = along_x ? integral.width() : integral.height();
  const int other = along_x ? integral.height() : integral.width();
  std::vector<double> out(static_cast<size_t>(room) + 1, 0);
  const auto strip = [&](int end, int low, int high) {
    return along_x ? integral.sum(0, low, end, high) : integral.sum(low, 0, high, end);
  };
  for (int end = 1; end <= room; ++end)
    for (const Segment& segment : across)
      out[static_cast<size_t>(end)] += strip(end, segment.start, segment.end);
  if (!across.empty()) return out;
  const double mean = strip(room, 0, other) / room;
  for (int end = 1; end <= room; ++end)
    out[static_cast<size_t>(end)] = strip(end, 0, other) - mean * end;
  return out;
}

/// Segments grouped by similar size, with equal sizes within a group.
struct Groups {
  std::vector<int> sizes;  ///< Sizes of the groups.
  std::vector<size_t> of;  ///< Group of each segment.
};

Groups grouped(const std::vector<Segment>& segments, int tolerance) {
  std::vector<size_t> order(segments.size());
  for (size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return segments[a].size() < segments[b].size(); });
  Groups out;
  out.of.resize(segments.size());
  for (size_t begin = 0; begin < order.size();) {
    size_t end = begin;
    int sum = 0;
    while (end < order.size() &&
           segments[order[end]].size() - segments[order[begin]].size() <= tolerance)
      sum += segments[order[end++]].size();
    const auto count = static_cast<int>(end - begin);
    for (size_t i = begin; i < end; ++i) out.of[order[i]] = out.sizes.size();
    out.sizes.push_back((sum + count / 2) / count);
    begin = end;
  }
  return out;
}

/// Starts of the segments with the size of their group, keeping their centres.
Lines starts(const std::vector<Segment>& segments, const Groups& groups, bool regular) {
  Lines out{};
  for (size_t i = 0; i < segments.size(); ++i)
    out[i] = static_cast<int16_t>(
        std::max(0, segments[i].start + (segments[i].size() - groups.sizes[groups.of[i]]) / 2));
  return regular ? nearest_even(out, static_cast<int>(segments.size())) : out;
}

int find_windows_production(const Rules& rules, int grid, bool with_door) {
  for (const int id : rules.productions_of(grid))
    if (rules.production(id).op == Op::windows &&
        (rules.production(id).parts.size() > 1) == with_door)
      return id;
  return -1;
}

/// The windows of a picture, and the lines of their grid.
struct WindowLayout {
  const FoldedIntegral& integral;
  const Layout& layout;
};

/// Adds the production `id`, with one kind of windows for sizes that differ by at most `tolerance`.
/// False if there are too many kinds.
bool add_grid(const MoveContext& context, TreeState& state, int i, int id,
              const WindowLayout& found, int tolerance) {
  const auto& [integral, layout] = found;
  const Rules& rules = context.model.rules();
  const int symbol = rules.production(id).parts[0];
  const SymbolInfo& info = rules.symbol(symbol);
  const int windows = find_windows_production(rules, symbol, false);
  if (windows < 0) return false;
  const Groups widths = grouped(layout.columns, tolerance),
               heights = grouped(layout.rows, tolerance);
  const size_t kinds = widths.sizes.size() * heights.sizes.size();
  if (kinds > (info.identical ? 1 : static_cast<size_t>(context.model.limits().max_kinds)))
    return false;
  Node grid;
  grid.symbol = static_cast<int16_t>(symbol);
  grid.parent_op = static_cast<int8_t>(Op::grid);
  grid.columns = static_cast<int16_t>(layout.columns.size());
  grid.rows = static_cast<int16_t>(layout.rows.size());
  grid.left = starts(layout.columns, widths, info.regular);
  grid.top = starts(layout.rows, heights, info.regular);
  std::vector<Node> parts;
  for (const int height : heights.sizes)
    for (const int width : widths.sizes) {
      Node window;
      window.symbol = static_cast<int16_t>(rules.production(windows).parts[0]);
      window.parent_op = static_cast<int8_t>(Op::windows);
      window.width = static_cast<int16_t>(width);
      window.height = static_cast<int16_t>(height);
      parts.push_back(window);
    }
  for (size_t row = 0; !info.identical && row < layout.rows.size(); ++row)
    for (size_t column = 0; column < layout.columns.size(); ++column) {
      const Segment &x = layout.columns[column], &y = layout.rows[row];
      const size_t kind = heights.of[row] * widths.sizes.size() + widths.of[column] + 1;
      if (integral.sum(x.start, y.start, x.end, y.end) > 0)
        grid.set_kind(static_cast<int>(column), static_cast<int>(row), static_cast<int>(kind));
    }
  state.grow(i, id, {grid});
  state.grow(i + 1, windows, parts);
  return true;
}

/// Adds the cheapest variant with a door: at `there`, or in some column from some row down to the
/// ground.
void add_doors(const MoveContext& context, const TreeState& state, int i, const Rect& there,
               std::vector<TreeState>& out) {
  const Rules& rules = context.model.rules();
  const Node& grid = state.tree[i + 1];
  const int id = find_windows_production(rules, grid.symbol, true);
  if (id < 0) return;
  const int ground = state.area(i).height;
  std::vector<Rect> places;
  if (there.x1 > there.x0) places.push_back(there);
  for (size_t column = 0; column < static_cast<size_t>(grid.columns); ++column)
    for (size_t row = 0; row < static_cast<size_t>(grid.rows); ++row)
      places.push_back(
          {grid.left[column], grid.top[row], grid.left[column] + state.tree[i + 2].width, ground});
  double lowest = std::numeric_limits<double>::infinity();
  TreeState best;
  for (const Rect& place : places) {
    TreeState with = state;
    Node door;
    door.symbol = static_cast<int16_t>(rules.production(id).parts[1]);
    door.parent_op = static_cast<int8_t>(Op::windows);
    door.x = static_cast<int16_t>(place.x0), door.y = static_cast<int16_t>(place.y0);
    door.width = static_cast<int16_t>(place.x1 - place.x0);
    door.height = static_cast<int16_t>(place.y1 - place.y0);
    with.insert(i + 1, with.tree.end(i + 1), door);
    with.tree[i + 1].production = static_cast<int16_t>(id);
    const double bits = context.model.energy(with);
    if (!(bits < lowest)) continue;
    lowest = bits;
    best = std::move(with);
  }
  if (std::isfinite(lowest)) out.push_back(std::move(best));
}

}  // namespace

Layout find_layout(const FoldedIntegral& integral, const Limits& limits, double cost, int turns,
                   bool rows_first) {
  Layout out;
  const auto find = [&](bool along_x, const std::vector<Segment>& across) {
    const int room = along_x ? integral.width() : integral.height();
    return best_segments(before(integral, along_x, across),
                         {limits.min_size, room, limits.max_lines, cost});
  };
  if (rows_first) out.rows = find(false, {});
  out.columns = find(true, out.rows);
  out.rows = find(false, out.columns);
  for (int turn = 0; turn < turns && !out.empty(); ++turn) {
    const Layout last = out;
    out.columns = find(true, out.rows);
    if (out.empty()) break;
    out.rows = find(false, out.columns);
    if (last.columns == out.columns && last.rows == out.rows) break;
  }
  return out;
}

std::vector<TreeState> grid_candidates(const MoveContext& context, const TreeState& state, int i,
                                       const FoldedIntegral& integral, const Layout& layout,
                                       const Rect& door) {
  const Rules& rules = context.model.rules();
  std::vector<TreeState> out;
  for (const int id : rules.productions_of(state.tree[i].symbol)) {
    if (rules.production(id).op != Op::grid) continue;
    const bool identical = rules.symbol(rules.production(id).parts[0]).identical;
    for (const int tolerance : {0, 1, 2, 3, 5, 8, 12, 20}) {
      TreeState with = state;
      if (!add_grid(context, with, i, id, {integral, layout},
                    identical ? std::max(integral.width(), integral.height()) : tolerance))
        continue;
      if (!std::isfinite(context.model.energy(with))) continue;
      add_doors(context, with, i, door, out);
      out.push_back(std::move(with));
      if (identical) break;
    }
  }
  return out;
}

}  // namespace vug::fit
