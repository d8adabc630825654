// Changes the distance of a regular grid's lines; the first or the last of them stays.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool pitch(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const Rules& rules = shop.model.rules();
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
  const int by = step(forward, back);
  Node& grid = tree[i];
  Lines& lines = along_x ? grid.left : grid.top;
  for (int line = 0; line < count_of(grid); ++line) {
    const int from_fixed = last_stays ? line - count_of(grid) + 1 : line;
    lines[static_cast<size_t>(line)] =
        static_cast<int16_t>(lines[static_cast<size_t>(line)] + from_fixed * by);
  }
  state.changed(i);
  return shop.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(pitch) {
  return {{"pitch", "move", "Changes the distance of a regular grid's columns or rows.", "", {}},
          2,
          pitch};
}
