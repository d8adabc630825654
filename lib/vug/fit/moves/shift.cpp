// SPDX-License-Identifier: Apache-2.0
// Moves a grid, or a free-standing element, in its area by a few pixels.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool shift(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  Tree& tree = state.tree;
  const auto by_itself = [&](int i) {
    return is_terminal(context, state, i) && !context.model.in_grid(tree[i]);
  };
  const auto fits = [&](int i) { return is_grid(context, state, i) || by_itself(i); };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool along_x = forward.flip();
  back.flip(along_x);
  const int by = step(forward, back);
  Node& node = tree[i];
  if (is_grid(context, state, i)) {
    shift_lines(node, along_x, by);
  } else {
    add(along_x ? node.x : node.y, by);
    state.invalidate_bits(tree.parent(i));
  }
  state.invalidate_bits(i);
  return context.model.fits(state, i);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(shift) {
  return {{"shift", "move", "Moves a grid, a door or a shop by a few pixels.", "", {}}, 3, shift};
}
