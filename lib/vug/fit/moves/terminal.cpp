// SPDX-License-Identifier: Apache-2.0
// Changes the content of an element: for example from a window to a door or a shop.
#include <vug/fit/move.h>

#include <algorithm>

namespace vug::fit {
namespace {

bool terminal(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  Tree& tree = state.tree;
  const auto fits = [&](int i) {
    return tree[i].production >= 0 && rules.production(tree[i].production).op == Op::terminal;
  };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  std::vector<int> ids;
  for (const int id : rules.productions_of(tree[i].symbol))
    if (rules.production(id).op == Op::terminal) ids.push_back(id);
  const auto count = static_cast<int>(ids.size());
  back.below(count,
             static_cast<int>(std::find(ids.begin(), ids.end(), tree[i].production) - ids.begin()));
  const int id = ids[static_cast<size_t>(forward.below(count))];
  tree[i].production = static_cast<int16_t>(id);
  tree[i + 1].symbol = static_cast<int16_t>(rules.production(id).parts[0]);
  state.invalidate_bits(i), state.invalidate_bits(i + 1);
  return true;
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(terminal) {
  return {{"terminal", "move", "Changes the content of an element.", "", {}}, 1, terminal};
}
