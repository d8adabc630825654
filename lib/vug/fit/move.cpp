// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/move.h>

#include <algorithm>

namespace vug::fit {

inference::Moves<TreeState> moves(const MoveContext& context,
                                  const std::vector<std::string>& names) {
  inference::Moves<TreeState> out;
  for (const MoveKind* kind : move_kinds()) {
    const bool wanted =
        names.empty() || std::find(names.begin(), names.end(), kind->info.name) != names.end();
    if (wanted)
      out.push_back({kind->info.name, kind->weight,
                     [&context, kind](TreeState& state, Choices& forward, Choices& back) {
                       return kind->propose(context, state, forward, back) && forward.possible() &&
                              back.possible();
                     }});
  }
  return out;
}

bool move_edge(const MoveContext& context, TreeState& state, int i, bool along_x, bool low,
               int by) {
  const int above = state.tree.parent(i);
  Node& node = state.tree[i];
  const bool in_grid = context.model.in_grid(node);
  add(along_x ? node.width : node.height, low ? -by : by);
  if (low && in_grid) shift_lines(state.tree[above], along_x, by);
  if (low && !in_grid) add(along_x ? node.x : node.y, by);
  state.invalidate_bits(i), state.invalidate_bits(above);
  return context.model.fits(state, i) && (!in_grid || context.model.fits(state, above));
}

}  // namespace vug::fit
