// SPDX-License-Identifier: Apache-2.0
// Adds a window kind to a grid whose windows may differ, or removes the last kind if no cell uses
// it.
#include <vug/fit/model/cells.h>

namespace vug::fit {
namespace {

/// Chooses, or scores, the window size of the last kind.
void choose_size(const MoveContext& context, const TreeState& state, int i, Choices& choices,
                 Node& window) {
  const Area& area = state.area(i);
  const int min_size = context.model.limits().min_size;
  window.width = static_cast<int16_t>(choices.between(min_size, area.width, window.width));
  window.height = static_cast<int16_t>(choices.between(min_size, area.height, window.height));
}

bool holds(const Node& grid, int kind) {
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column)
      if (grid.kind(column, row) == kind) return true;
  return false;
}

bool kinds(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return has_cells(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool add = forward.flip();
  back.flip(!add);
  const int count = GridAxis(context, state, i, true).kinds;
  if (add) {
    if (count >= context.model.limits().max_kinds) return false;
    Node window;
    window.symbol = state.tree[i + 1].symbol;
    window.parent_op = state.tree[i + 1].parent_op;
    choose_size(context, state, i, forward, window);
    state.insert(i, i + 1 + count, window);
    return context.model.fits(state, i);
  }
  if (count < 2 || holds(state.tree[i], count)) return false;
  Node window = state.tree[i + count];
  choose_size(context, state, i, back, window);
  state.erase(i, i + count);
  return true;
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(kinds) {
  return {{"kinds", "move", "Adds a window kind to a grid, or removes one.", "", {}}, 1, kinds};
}
