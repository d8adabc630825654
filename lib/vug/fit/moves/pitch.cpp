// SPDX-License-Identifier: Apache-2.0
// Changes the spacing of a regular grid's lines; the first or the last line stays in place.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool pitch(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  Tree& tree = state.tree;
  const bool along_x = forward.flip();
  back.flip(along_x);
  const auto count_of = [&](const Node& grid) { return along_x ? grid.columns : grid.rows; };
  const auto fits = [&](int i) {
    return rules.symbol(tree[i].symbol).regular && count_of(tree[i]) > 1;
  };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool last_stays = forward.flip();
  back.flip(last_stays);
  const bool each = forward.flip();  // By this much for each spacing, or for the whole span.
  back.flip(each);
  Node& grid = tree[i];
  const int by = step(forward, back) * (each ? count_of(grid) - 1 : 1);
  Lines& lines = along_x ? grid.left : grid.top;
  const int count = count_of(grid);
  const int span = lines[static_cast<size_t>(count - 1)] - lines[0] + by;
  lines = even_lines(last_stays ? lines[0] - by : lines[0], span, count);
  state.invalidate_bits(i);
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(pitch) {
  return {{"pitch", "move", "Changes the spacing of a regular grid's columns or rows.", "", {}},
          2,
          pitch};
}
