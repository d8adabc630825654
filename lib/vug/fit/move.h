// SPDX-License-Identifier: Apache-2.0
// Interface of the sampler's moves. A move changes a tree and scores the reverse move; see
// inference/choices.h.
#pragma once

#include <vug/base/kind.h>
#include <vug/fit/model/successors.h>
#include <vug/inference/chain.h>

namespace vug::fit {

using inference::Choices;

struct MoveKind {
  KindInfo info;
  double weight = 1;  ///< Relative frequency of proposals.
  bool (*propose)(const MoveContext&, TreeState&, Choices& forward, Choices& back) = nullptr;
};

/// One file per kind in moves/.
const std::vector<const MoveKind*>& move_kinds();

/// The moves with these names, or all moves, for use in chains; the context must outlive them.
inference::Moves<TreeState> moves(const MoveContext& context,
                                  const std::vector<std::string>& names = {});

/// Picks one of the nodes for which `fits(node index)` holds, uniformly; -1 without one.
template <class Fits>
int pick(const TreeState& state, Choices& forward, const Fits& fits) {
  int count = 0;
  for (int i = 0; i < state.tree.size(); ++i) count += fits(i) ? 1 : 0;
  if (count == 0) return -1;
  int left = forward.below(count);
  for (int i = 0; i < state.tree.size(); ++i)
    if (fits(i) && left-- == 0) return i;
  return -1;
}

/// Scores the choice of node `which` by pick().
template <class Fits>
void score_pick(const TreeState& state, Choices& back, int which, const Fits& fits) {
  int count = 0, place = -1;
  for (int i = 0; i < state.tree.size(); ++i) {
    if (!fits(i)) continue;
    if (i == which) place = count;
    ++count;
  }
  back.below(count, place);
}

/// Picks one of the nodes that the move leaves unchanged, so that the reverse move picks it again.
template <class Fits>
int pick_same(const TreeState& state, Choices& forward, Choices& back, const Fits& fits) {
  const int i = pick(state, forward, fits);
  if (i >= 0) score_pick(state, back, i, fits);
  return i;
}

/// A step of 1 to 16 pixels in either direction, short steps being more frequent; the reverse
/// choice has the opposite sign.
inline int step(Choices& forward, Choices& back) {
  const int scale = forward.below(3);
  const bool down = forward.flip();
  const int size = forward.between(1, 1 << (2 * scale));
  back.below(3, scale);
  back.flip(!down);
  back.between(1, 1 << (2 * scale), size);
  return down ? -size : size;
}

/// Adds to a parameter.
inline void add(int16_t& value, int by) { value = static_cast<int16_t>(value + by); }

/// Shifts all columns, or all rows, of a grid.
inline void shift_lines(Node& grid, bool along_x, int by) {
  Lines& lines = along_x ? grid.left : grid.top;
  const int count = along_x ? grid.columns : grid.rows;
  for (int line = 0; line < count; ++line) add(lines[static_cast<size_t>(line)], by);
}

/// Moves the lower or upper edge, along x or y, of a terminal. For a window of a grid this moves
/// the edge of all windows of its kind, and the grid's lines with a lower edge. False if the result
/// does not fit.
bool move_edge(const MoveContext& context, TreeState& state, int i, bool along_x, bool low, int by);

inline bool is_terminal(const MoveContext& context, const TreeState& state, int i) {
  return context.model.rules().symbol(state.tree[i].symbol).terminal;
}
inline bool is_grid(const MoveContext& context, const TreeState& state, int i) {
  return context.model.rules().symbol(state.tree[i].symbol).grid;
}

}  // namespace vug::fit

/// Opens the one definition that the file of a move exports; used outside of any namespace.
#define VUG_MOVE(name) VUG_EXPORT_KIND(vug::fit, MoveKind, name##_move)
