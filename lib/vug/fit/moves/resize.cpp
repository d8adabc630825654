// Moves one edge of the windows of a grid, or of what stands by itself, by a few pixels.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

void add(int16_t& value, int by) { value = static_cast<int16_t>(value + by); }

bool resize(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const Rules& rules = shop.model.rules();
  Tree& tree = state.tree;
  const auto fits = [&](int i) { return rules.symbol(tree[i].symbol).terminal; };
  const int i = pick(state, forward, fits);
  if (i < 0) return false;
  tell_pick(state, back, i, fits);
  const bool along_x = forward.flip(), low_edge = forward.flip();
  back.flip(along_x), back.flip(low_edge);
  const int by = step(forward, back);  // of the size
  Node& node = tree[i];
  add(along_x ? node.width : node.height, by);
  const int above = tree.parent(i);
  state.changed(i), state.changed(above);
  const bool in_grid = static_cast<Op>(node.made_by) == Op::windows &&
                       rules.symbol(node.symbol).look == Look::window;
  if (!in_grid) {
    if (low_edge) add(along_x ? node.x : node.y, -by);
    return shop.model.fits(state, i);
  }
  if (low_edge) {  // the whole grid moves, and windows of other kinds with it
    Node& grid = tree[above];
    Lines& lines = along_x ? grid.left : grid.top;
    const int count = along_x ? grid.columns : grid.rows;
    for (int line = 0; line < count; ++line) add(lines[static_cast<size_t>(line)], -by);
  }
  return shop.model.fits(state, i) && shop.model.fits(state, above);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(resize) {
  return {{"resize", "move", "Moves an edge of windows, a door or a shop by a few pixels.", "", {}},
          3,
          resize};
}
