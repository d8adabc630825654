// SPDX-License-Identifier: Apache-2.0
// Splits an undivided element in two, or merges two undivided neighbours.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

bool elements(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Limits& limits = context.model.limits();
  Tree& tree = state.tree;
  const auto plain = [&](int i) {
    return static_cast<Op>(tree[i].parent_op) == Op::elements && tree[i].production < 0;
  };
  const auto pair = [&](int i) {  // Together with the next element.
    if (!plain(i)) return false;
    const int above = tree.parent(i), next = tree.end(i);
    return next < tree.end(above) && plain(next);
  };
  const bool split = forward.flip();
  back.flip(!split);
  const int i = split ? pick(state, forward, plain) : pick(state, forward, pair);
  if (i < 0) return false;
  const int above = tree.parent(i);
  const int width = state.area(i).width, min_size = limits.min_size;
  if (split) {
    const bool last = tree.end(i) == tree.end(above);
    const int first = forward.between(min_size, width - min_size);
    if (!forward.possible()) return false;
    Node node = tree[i];
    node.extent = static_cast<int16_t>(last ? 0 : width - first);
    tree[i].extent = static_cast<int16_t>(first);
    state.invalidate_bits(i);
    state.insert(above, i + 1, node);
    score_pick(state, back, i, pair);
    return context.model.compute_areas(state);
  }
  const int next = tree.end(i), both = width + state.area(next).width;
  const bool last = tree.end(next) == tree.end(above);
  state.erase(above, next);
  tree[i].extent = static_cast<int16_t>(last ? 0 : both);
  state.invalidate_bits(i);
  score_pick(state, back, i, plain);
  back.between(min_size, both - min_size, width);
  return context.model.compute_areas(state);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(elements) {
  return {
      {"elements", "move", "Splits an empty element in two, or merges two.", "", {}}, 1, elements};
}
