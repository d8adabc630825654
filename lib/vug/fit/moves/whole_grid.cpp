// SPDX-License-Identifier: Apache-2.0
// Applies two productions at once, from an area to a grid and from the grid to its windows, or
// reverts both, since the state in between is rarely worth its bits.
#include <vug/fit/move.h>

#include <algorithm>
#include <utility>

namespace vug::fit {
namespace {

using GridProductions =
    std::pair<int, int>;  ///< A production to a grid, and one from that grid to windows.

std::vector<GridProductions> grid_productions(const Rules& rules, int symbol) {
  std::vector<GridProductions> out;
  for (const int first : rules.productions_of(symbol)) {
    if (rules.production(first).op != Op::grid) continue;
    for (const int second : rules.productions_of(rules.production(first).parts[0]))
      out.emplace_back(first, second);
  }
  return out;
}

bool whole_grid(const MoveContext& context, TreeState& state, Choices& forward, Choices& back) {
  const Rules& rules = context.model.rules();
  const Tree& tree = state.tree;
  const auto open = [&](int i) {
    return tree[i].production < 0 && !grid_productions(rules, tree[i].symbol).empty();
  };
  const auto closed = [&](int i) {
    return tree[i].production >= 0 && rules.production(tree[i].production).op == Op::grid &&
           tree[i + 1].production >= 0;
  };
  const bool grow = forward.flip();
  back.flip(!grow);
  const int i = grow ? pick(state, forward, open) : pick(state, forward, closed);
  if (i < 0) return false;
  const std::vector<GridProductions> choices = grid_productions(rules, tree[i].symbol);
  const auto count = static_cast<int>(choices.size());
  if (grow) {
    const GridProductions productions = choices[static_cast<size_t>(forward.below(count))];
    const auto grid = choose_successors(context, state, i, productions.first, forward, {});
    if (!grid) return false;
    apply_production(state, i, productions.first, *grid);
    // Windows are chosen in the grid's area, which is that of its parent.
    state.areas[static_cast<size_t>(i + 1)] = state.areas[static_cast<size_t>(i)];
    const auto windows = choose_successors(context, state, i + 1, productions.second, forward, {});
    if (!windows) return false;
    apply_production(state, i + 1, productions.second, *windows);
    score_pick(state, back, i, closed);
    return true;
  }
  const GridProductions productions = {tree[i].production, tree[i + 1].production};
  // The reverse move chooses the grid before its windows, but the windows can only be scored while
  // the grid exists.
  const Successors old_windows = successors_of(state, i + 1);
  undo_production(state, i + 1);
  Choices scored;
  scored.score();
  if (!choose_successors(context, state, i + 1, productions.second, scored, old_windows))
    return false;
  const Successors old_grid = successors_of(state, i);
  undo_production(state, i);
  score_pick(state, back, i, open);
  back.below(count, static_cast<int>(std::find(choices.begin(), choices.end(), productions) -
                                     choices.begin()));
  if (!choose_successors(context, state, i, productions.first, back, old_grid)) return false;
  back.append(scored);
  return true;
}

}  // namespace
}  // namespace vug::fit

VUG_MOVE(whole_grid) {
  return {{"whole_grid", "move", "Adds a grid with its windows to an area, or removes it.", "", {}},
          2,
          whole_grid};
}
