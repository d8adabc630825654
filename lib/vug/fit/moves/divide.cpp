// SPDX-License-Identifier: Apache-2.0
// Moves the line between two parts: the ground floor and the part above it, two elements, or the
// sides and the middle of a symmetric part.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool divide(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  Tree& tree = state.tree;
  const auto fits = [&](int i) {
    return tree[i].extent > 0 && static_cast<Op>(tree[i].parent_op) != Op::repeat;
  };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const Op op = static_cast<Op>(tree[i].parent_op);
  const bool far = op == Op::rows && forward.flip();
  if (op == Op::rows) back.flip(far);
  int by = 0;
  if (far) {  // To a position that the picture hints at.
    const Area& above = state.area(tree.parent(i));
    const int bottom = above.y + above.height, min_size = context.model.limits().min_size;
    const int low = above.y + min_size, high = bottom - min_size + 1;
    back.among(context.hints.floor, low, high, bottom - tree[i].extent);
    by = bottom - forward.among(context.hints.floor, low, high) - tree[i].extent;
  } else {
    by = step(forward, back) * (op == Op::mirror ? 2 : 1);
  }
  tree[i].extent = static_cast<int16_t>(tree[i].extent + by);
  const int next = tree.end(i);  // The next element absorbs the difference.
  if (op == Op::elements && tree[next].extent > 0) {
    tree[next].extent = static_cast<int16_t>(tree[next].extent - by);
    state.invalidate_bits(next);
    if (tree[next].extent <= 0) return false;
  }
  state.invalidate_bits(i);
  state.invalidate_areas();
  return tree[i].extent > 0 && context.model.compute_areas(state);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(divide) {
  return {{"divide", "move", "Moves the line between two parts of an area.", "", {}}, 2, divide};
}
