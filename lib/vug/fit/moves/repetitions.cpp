// SPDX-License-Identifier: Apache-2.0
// Changes the number of repetitions of a part.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool repetitions(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  Tree& tree = state.tree;
  const auto fits = [&](int i) { return static_cast<Op>(tree[i].parent_op) == Op::repeat; };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool more = forward.flip();
  back.flip(!more);
  tree[i].extent = static_cast<int16_t>(tree[i].extent + (more ? 1 : -1));
  state.invalidate_bits(i),
      state.invalidate_bits(tree.parent(i));  // Accounts for the left-over pixels.
  state.invalidate_areas();
  return tree[i].extent >= 2 && context.model.compute_areas(state);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(repetitions) {
  return {{"repetitions", "move", "Changes the number of repetitions of a part.", "", {}},
          1,
          repetitions};
}
