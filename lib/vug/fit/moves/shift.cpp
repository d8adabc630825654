// Moves a grid, or what stands by itself, in its area by a few pixels.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

void add(int16_t& value, int by) { value = static_cast<int16_t>(value + by); }

bool shift(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const Rules& rules = shop.model.rules();
  Tree& tree = state.tree;
  const auto by_itself = [&](int i) {
    const SymbolInfo& symbol = rules.symbol(tree[i].symbol);
    return symbol.terminal &&
           !(static_cast<Op>(tree[i].made_by) == Op::windows && symbol.look == Look::window);
  };
  const auto fits = [&](int i) { return is_grid(shop, state, i) || by_itself(i); };
  const int i = pick(state, forward, fits);
  if (i < 0) return false;
  tell_pick(state, back, i, fits);
  const bool along_x = forward.flip();
  back.flip(along_x);
  const int by = step(forward, back);
  Node& node = tree[i];
  if (is_grid(shop, state, i)) {
    Lines& lines = along_x ? node.left : node.top;
    const int count = along_x ? node.columns : node.rows;
    for (int line = 0; line < count; ++line) add(lines[static_cast<size_t>(line)], by);
  } else {
    add(along_x ? node.x : node.y, by);
    state.changed(tree.parent(i));
  }
  state.changed(i);
  return shop.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(shift) {
  return {{"shift", "move", "Moves a grid, a door or a shop by a few pixels.", "", {}}, 3, shift};
}
