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
  const std::vector<int>& ways = rules.productions_of(tree[i].symbol);
  const auto count = static_cast<int>(ways.size());
  Successors parts;
  if (grow) {
    const int way = ways[static_cast<size_t>(forward.below(count))];
    if (!choose_successors(context, state, i, way, forward, {}, parts)) return false;
    apply_production(state, i, way, parts);
    score_pick(state, back, i, closed);
    return true;
  }
  const int way = tree[i].production;
  const Successors old = successors_of(state, i);
  undo_production(state, i);
  score_pick(state, back, i, open);
  back.below(count, static_cast<int>(std::find(ways.begin(), ways.end(), way) - ways.begin()));
  return choose_successors(context, state, i, way, back, old, parts);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(rewrite) {
  return {{"rewrite", "move", "Applies a production, or reverts one.", "", {}}, 2, rewrite};
}
