// Applies a production to an area that has none, or takes one back whose parts have none.
#include <vug/fit/move.h>

#include <algorithm>

namespace vug::fit {
namespace {

bool rewrite(const Workshop& shop, State& state, Choices& forward, Choices& back) {
  const Rules& rules = shop.model.rules();
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
  Parts parts;
  if (grow) {
    const int way = ways[static_cast<size_t>(forward.below(count))];
    if (!choose_parts(shop, state, i, way, forward, {}, parts)) return false;
    put_parts(state, i, way, parts);
    tell_pick(state, back, i, closed);
    return true;
  }
  const int way = tree[i].production;
  const Parts old = parts_of(state, i);
  take_parts(state, i);
  tell_pick(state, back, i, open);
  back.below(count, static_cast<int>(std::find(ways.begin(), ways.end(), way) - ways.begin()));
  return choose_parts(shop, state, i, way, back, old, parts);
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(rewrite) {
  return {{"rewrite", "move", "Applies a production, or takes one back.", "", {}}, 2, rewrite};
}
