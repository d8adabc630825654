// SPDX-License-Identifier: Apache-2.0
// Changes the type of a grid. Lines of a regular grid are jittered when it becomes irregular; the
// reverse requires lines close to evenly spaced ones.
#include <vug/fit/move.h>

#include <algorithm>
#include <cstdlib>

namespace vug::fit {
namespace {

constexpr int kMaxLineJitter = 2;  // Pixels.

int span_of(const Lines& lines, int count) {
  return lines[static_cast<size_t>(count - 1)] - lines[0];
}

/// Spans for which evenly spaced lines from the first one are close to all lines.
std::vector<int> spans(const Lines& lines, int count) {
  std::vector<int> out;
  const int middle = span_of(lines, count);
  for (int span = std::max(1, middle - kMaxLineJitter); span <= middle + kMaxLineJitter; ++span) {
    const Lines even = even_lines(lines[0], span, count);
    bool near = true;
    for (size_t i = 1; i < static_cast<size_t>(count); ++i)
      near = near && std::abs(lines[i] - even[i]) <= kMaxLineJitter;
    if (near) out.push_back(span);
  }
  return out;
}

void jitter_lines(Lines& lines, int count, Choices& forward, Choices& back) {
  if (count < 2) return;
  const int span = span_of(lines, count);
  for (int i = 1; i < count; ++i)
    lines[static_cast<size_t>(i)] = static_cast<int16_t>(
        lines[static_cast<size_t>(i)] + forward.between(-kMaxLineJitter, kMaxLineJitter));
  const std::vector<int> near = spans(lines, count);
  back.below(static_cast<int>(near.size()),
             static_cast<int>(std::find(near.begin(), near.end(), span) - near.begin()));
}

bool even_out_lines(Lines& lines, int count, Choices& forward, Choices& back) {
  if (count < 2) return true;
  const std::vector<int> near = spans(lines, count);
  if (near.empty()) return false;
  const int span = near[static_cast<size_t>(forward.below(static_cast<int>(near.size())))];
  const Lines even = even_lines(lines[0], span, count);
  for (int i = 1; i < count; ++i) {
    int16_t& line = lines[static_cast<size_t>(i)];
    const int straight = even[static_cast<size_t>(i)];
    back.between(-kMaxLineJitter, kMaxLineJitter, line - straight);
    line = static_cast<int16_t>(straight);
  }
  return true;
}

bool grid_type(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  Tree& tree = state.tree;
  const auto fits = [&](int i) {
    return tree[i].production >= 0 && rules.production(tree[i].production).op == Op::grid;
  };
  const int above = pick_same(state, forward, back, fits);
  if (above < 0) return false;
  std::vector<int> types;  // Productions to grids.
  for (const int id : rules.productions_of(tree[above].symbol))
    if (rules.production(id).op == Op::grid) types.push_back(id);
  const auto count = static_cast<int>(types.size());
  const int type = types[static_cast<size_t>(forward.below(count))];
  back.below(count, static_cast<int>(std::find(types.begin(), types.end(), tree[above].production) -
                                     types.begin()));
  if (type == tree[above].production) return false;

  const int i = above + 1;
  Node& grid = tree[i];
  const SymbolInfo& from = rules.symbol(grid.symbol);
  const int symbol = rules.production(type).parts[0];
  const SymbolInfo& to = rules.symbol(symbol);
  if (grid.production >= 0) {
    const std::vector<int>& parts = rules.production(grid.production).parts;
    const std::vector<int>& ids = rules.productions_of(symbol);
    const auto same = std::find_if(ids.begin(), ids.end(),
                                   [&](int id) { return rules.production(id).parts == parts; });
    if (same == ids.end()) return false;
    const Cells full = grid.full_cells();
    if (from.identical && !to.identical) grid.cells = full;
    if (!from.identical && to.identical) {
      // All children except the door.
      const int kinds = grid.size - static_cast<int>(parts.size());
      if (kinds != 1 || grid.cells != full) return false;
      grid.cells = {};
    }
    grid.production = static_cast<int16_t>(*same);
  }
  if (from.regular && !to.regular) {
    jitter_lines(grid.left, grid.columns, forward, back);
    jitter_lines(grid.top, grid.rows, forward, back);
  }
  if (!from.regular && to.regular &&
      !(even_out_lines(grid.left, grid.columns, forward, back) &&
        even_out_lines(grid.top, grid.rows, forward, back)))
    return false;
  tree[above].production = static_cast<int16_t>(type);
  grid.symbol = static_cast<int16_t>(symbol);
  state.invalidate_bits(i);
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(grid_type) {
  return {{"grid_type", "move", "Changes the type of a grid.", "", {}}, 1, grid_type};
}
