// SPDX-License-Identifier: Apache-2.0
// Changes the content of one cell, or of a whole column or row of cells, in a grid whose windows
// differ.
#include <vug/fit/model/cells.h>

namespace vug::fit {
namespace {

bool cell(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const auto fits = [&](int i) { return has_cells(context, state, i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  state.invalidate_bits(i);
  const bool whole_line = forward.flip(), along_x = forward.flip();
  back.flip(whole_line), back.flip(along_x);
  GridAxis axis(context, state, i, along_x);
  const int line = forward.below(axis.count);
  back.below(axis.count, line);
  if (whole_line) {
    axis.choose_cells(line, back);
    return axis.choose_cells(line, forward) && context.model.fits(state, i);
  }
  Node& grid = axis.grid;
  const int across = along_x ? grid.rows : grid.columns;
  const int other = forward.below(across);
  back.below(across, other);
  const int column = along_x ? line : other, row = along_x ? other : line;
  back.below(axis.kinds + 1, grid.kind(column, row));
  grid.set_kind(column, row, forward.below(axis.kinds + 1));
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(cell) {
  return {{"cell", "move", "Changes the content of cells of a grid.", "", {}}, 2, cell};
}
