// SPDX-License-Identifier: Apache-2.0
// Applies a production to an undivided node, or reverts one whose children are undivided.
#include <vug/fit/move.h>

#include <algorithm>

namespace vug::fit {
namespace {

bool rewrite(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  const Tree& tree = state.tree;
  const auto open = [&](int i) {
    return tree[i].production < 0 && !rules.productions_of(tree[i].symbol).empty();
  };
  const auto closed = [&](int i) {
    if (tree[i].production < 0) return false;
    for (int part = i + 1; part < tree.end(i); ++part)
      if (tree[part].production >= 0) return false;
    return true;
  };
  const bool grow = forward.flip();
  back.flip(!grow);
  const int i = grow ? pick(state, forward, open) : pick(state, forward, closed);
  if (i < 0) return false;
  const std::vector<int>& ids = rules.productions_of(tree[i].symbol);
  const auto count = static_cast<int>(ids.size());
  if (grow) {
    const int id = ids[static_cast<size_t>(forward.below(count))];
    const auto parts = choose_successors(context, state, i, id, forward, {});
    if (!parts) return false;
    apply_production(state, i, id, *parts);
    score_pick(state, back, i, closed);
    return true;
  }
  const int id = tree[i].production;
  const Successors old = successors_of(state, i);
  undo_production(state, i);
  score_pick(state, back, i, open);
  back.below(count, static_cast<int>(std::find(ids.begin(), ids.end(), id) - ids.begin()));
  return choose_successors(context, state, i, id, back, old).has_value();
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(rewrite) {
  return {{"rewrite", "move", "Applies a production, or reverts one.", "", {}}, 2, rewrite};
}
