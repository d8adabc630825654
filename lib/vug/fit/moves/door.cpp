// SPDX-License-Identifier: Apache-2.0
// Adds a door to a grid, or removes it.
#include <vug/fit/move.h>

namespace vug::fit {
namespace {

/// The production of a symbol to windows of the same kind with (or without) a door; -1 if there is
/// none.
int find_other_production(const Rules& rules, int symbol, int id, bool with_door) {
  for (const int other : rules.productions_of(symbol)) {
    const Production& production = rules.production(other);
    if (production.op == Op::windows && (production.parts.size() > 1) == with_door &&
        production.parts[0] == rules.production(id).parts[0])
      return other;
  }
  return -1;
}

bool door(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  Tree& tree = state.tree;
  const auto fits = [&](int i) {
    return tree[i].production >= 0 && rules.production(tree[i].production).op == Op::windows;
  };
  const int i = pick_same(state, forward, back, fits);
  if (i < 0) return false;
  const bool has_door = rules.production(tree[i].production).parts.size() > 1;
  const int id = find_other_production(rules, tree[i].symbol, tree[i].production, !has_door);
  if (id < 0) return false;
  Node node;
  if (has_door) {
    choose_rect(context, state, i, back, tree[tree.end(i) - 1], node);
    state.erase(i, tree.end(i) - 1);
  } else {
    choose_rect(context, state, i, forward, {}, node);
    node.symbol = static_cast<int16_t>(rules.production(id).parts[1]);
    node.parent_op = static_cast<int8_t>(Op::windows);
    state.insert(i, tree.end(i), node);
  }
  tree[i].production = static_cast<int16_t>(id);
  state.invalidate_bits(i);
  return true;
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(door) {
  return {{"door", "move", "Adds a door to a grid, or removes it.", "", {}}, 1, door};
}
