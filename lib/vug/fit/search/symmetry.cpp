// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/search/symmetry.h>

#include <algorithm>

namespace vug::fit {
namespace {

constexpr int kMaxJitter = 2;  // Pixels.

/// How the columns of a part are mapped to its copies in the whole area.
struct ColumnSymmetry {
  Op op = Op::mirror;
  int times = 2;  ///< Number of copies, including the part itself.

  int part_width(int room) const { return room / times; }
  /// Start of a window in copy `again` > 0, for a window of that width that starts at x in the
  /// part.
  int place(int room, int again, int x, int width) const {
    return op == Op::mirror ? room - x - width : repetition_offset(room, times, again) + x;
  }
};

/// The production of a symbol to that grid; -1 without one.
int find_grid_production(const Rules& rules, int symbol, int grid) {
  for (const int id : rules.productions_of(symbol))
    if (rules.production(id).op == Op::grid && rules.production(id).parts[0] == grid) return id;
  return -1;
}

/// Maximum deviation of a grid's lines from exact symmetry.
int jitter(const MoveContext& context, const Node& grid) {
  return context.model.rules().symbol(grid.symbol).regular ? 0 : kMaxJitter;
}

/// Column of the whole grid for a column of copy `again`.
int column_of(const ColumnSymmetry& symmetry, int columns, int again, int column) {
  const bool turned = symmetry.op == Op::mirror && again % 2 == 1;
  return again * columns + (turned ? columns - 1 - column : column);
}

/// The production of node i to one part by that operation, if that part can be a grid like the one
/// below node i; -1 otherwise.
int folding_production(const MoveContext& context, const TreeState& state, int i, Op op) {
  const Rules& rules = context.model.rules();
  for (const int id : rules.productions_of(state.tree[i].symbol)) {
    const Production& production = rules.production(id);
    if (production.op == op && production.parts.size() == 1 &&
        find_grid_production(rules, production.parts[0], state.tree[i + 1].symbol) >= 0)
      return id;
  }
  return -1;
}

/// Whether node i was rewritten to a grid with windows of one kind and no door.
bool can_fold(const MoveContext& context, const TreeState& state, int i) {
  const Rules& rules = context.model.rules();
  const Tree& tree = state.tree;
  if (tree[i].production < 0 || rules.production(tree[i].production).op != Op::grid) return false;
  return tree[i + 1].production >= 0 && tree[i + 1].size == 2 &&
         rules.production(tree[i + 1].production).parts.size() == 1;
}

/// Whether node i was rewritten to one part by that operation and can be unfolded.
bool can_unfold(const MoveContext& context, const TreeState& state, int i, Op op) {
  const Rules& rules = context.model.rules();
  const Tree& tree = state.tree;
  if (tree[i].production < 0) return false;
  const Production& production = rules.production(tree[i].production);
  return production.op == op && production.parts.size() == 1 && can_fold(context, state, i + 1) &&
         find_grid_production(rules, tree[i].symbol, tree[i + 2].symbol) >= 0;
}

bool fold(const MoveContext& context, TreeState& state, int i, int production,
          const ColumnSymmetry& symmetry, Choices& back) {
  const Rules& rules = context.model.rules();
  const Tree& tree = state.tree;
  const int room = state.area(i).width, part_width = symmetry.part_width(room);
  Node grid = tree[i + 1];
  const Node whole = grid, window = tree[i + 2];
  if (whole.columns % symmetry.times != 0 || part_width < context.model.limits().min_size)
    return false;
  grid.columns = static_cast<int16_t>(whole.columns / symmetry.times);
  const int most = jitter(context, whole);
  for (int column = 0; column < whole.columns; ++column) {
    const auto at = static_cast<size_t>(column);
    grid.left[at] = column < grid.columns ? whole.left[at] : int16_t{0};
  }
  for (int again = 1; again < symmetry.times; ++again)
    for (int column = 0; column < grid.columns; ++column) {
      const int other = column_of(symmetry, grid.columns, again, column);
      const int place =
          symmetry.place(room, again, grid.left[static_cast<size_t>(column)], window.width);
      if (most > 0) back.between(-most, most, whole.left[static_cast<size_t>(other)] - place);
      if (most == 0 && whole.left[static_cast<size_t>(other)] != place) return false;
      for (int row = 0; row < grid.rows; ++row)
        if (whole.kind(other, row) != whole.kind(column, row)) return false;
    }
  for (int row = 0; row < grid.rows; ++row)
    for (int column = grid.columns; column < whole.columns; ++column) grid.set_kind(column, row, 0);

  Node above = tree[i], part;
  part.symbol = static_cast<int16_t>(rules.production(production).parts[0]);
  part.parent_op = static_cast<int8_t>(symmetry.op);
  part.extent = static_cast<int16_t>(symmetry.op == Op::repeat ? symmetry.times : 0);
  part.production = static_cast<int16_t>(find_grid_production(rules, part.symbol, grid.symbol));
  part.size = 3;
  above.production = static_cast<int16_t>(production);
  above.size = 4;
  // The area is unchanged and needed by the following choices.
  const Area area = state.area(i);
  state.replace(i, {above, part, grid, window});
  state.areas[static_cast<size_t>(i)] = area;
  return back.possible();
}

bool unfold(const MoveContext& context, TreeState& state, int i, const ColumnSymmetry& symmetry,
            Choices& forward) {
  const Rules& rules = context.model.rules();
  const Tree& tree = state.tree;
  const int room = state.area(i).width;
  Node above = tree[i];
  const Node part = tree[i + 2], window = tree[i + 3];
  Node grid = part;
  if (symmetry.times * part.columns > context.model.limits().max_lines) return false;
  grid.columns = static_cast<int16_t>(symmetry.times * part.columns);
  const int most = jitter(context, part);
  for (int column = 0; column < part.columns; ++column)
    grid.left[static_cast<size_t>(column)] = part.left[static_cast<size_t>(column)];
  for (int again = 1; again < symmetry.times; ++again)
    for (int column = 0; column < part.columns; ++column) {
      const int other = column_of(symmetry, part.columns, again, column);
      const int place =
          symmetry.place(room, again, part.left[static_cast<size_t>(column)], window.width);
      grid.left[static_cast<size_t>(other)] =
          static_cast<int16_t>(place + (most > 0 ? forward.between(-most, most) : 0));
      for (int row = 0; row < part.rows; ++row) grid.set_kind(other, row, part.kind(column, row));
    }
  above.production = static_cast<int16_t>(find_grid_production(rules, above.symbol, grid.symbol));
  above.size = 3;
  const Area area = state.area(i);
  state.replace(i, {above, grid, window});
  state.areas[static_cast<size_t>(i)] = area;
  return true;
}

}  // namespace

bool fold_or_unfold(const MoveContext& context, TreeState& state, Op op, Choices& forward,
                    Choices& back) {
  const int most = context.model.limits().max_repeats;
  const auto plain = [&](int i) {
    return can_fold(context, state, i) && folding_production(context, state, i, op) >= 0;
  };
  const auto folded = [&](int i) { return can_unfold(context, state, i, op); };
  // The number of copies, which is only a choice for repetitions.
  const auto times = [&](Choices& choices, int fixed) {
    return op == Op::repeat ? choices.between(2, most, fixed) : 2;
  };
  const bool once = forward.flip();
  back.flip(!once);
  const int i = once ? pick(state, forward, plain) : pick(state, forward, folded);
  if (i < 0) return false;
  if (!once) {
    const ColumnSymmetry symmetry{op, op == Op::repeat ? state.tree[i + 1].extent : 2};
    if (!unfold(context, state, i, symmetry, forward)) return false;
    score_pick(state, back, i, plain);
    times(back, symmetry.times);
    return true;
  }
  const ColumnSymmetry symmetry{op, times(forward, 0)};
  // Unfolding takes the same choices in order: first the node, then the positions.
  Choices positions;
  positions.score();
  if (!fold(context, state, i, folding_production(context, state, i, op), symmetry, positions))
    return false;
  score_pick(state, back, i, folded);
  back.append(positions);
  return true;
}

}  // namespace vug::fit
