#include <vug/fit/move.h>

#include <algorithm>

namespace vug::fit {

#define VUG_KIND(name) const MoveKind& name##_move();
#include <vug/fit/moves_kinds.inc>
#undef VUG_KIND

const std::vector<const MoveKind*>& move_kinds() {
#define VUG_KIND(name) &name##_move(),
  static const std::vector<const MoveKind*> kinds = {
#include <vug/fit/moves_kinds.inc>
  };
#undef VUG_KIND
  return kinds;
}

inference::Moves<State> moves(const Workshop& shop, const std::vector<std::string>& names) {
  inference::Moves<State> out;
  for (const MoveKind* kind : move_kinds()) {
    const bool wanted =
        names.empty() || std::find(names.begin(), names.end(), kind->info.name) != names.end();
    if (wanted)
      out.push_back({kind->info.name, kind->weight,
                     [&shop, kind](State& state, Choices& forward, Choices& back) {
                       return kind->propose(shop, state, forward, back) && forward.possible() &&
                              back.possible();
                     }});
  }
  return out;
}

bool move_edge(const Workshop& shop, State& state, int i, bool along_x, bool low, int by) {
  const int above = state.tree.parent(i);
  Node& node = state.tree[i];
  const bool in_grid = shop.model.in_grid(node);
  add(along_x ? node.width : node.height, low ? -by : by);
  if (low && in_grid) shift_lines(state.tree[above], along_x, by);
  if (low && !in_grid) add(along_x ? node.x : node.y, by);
  state.changed(i), state.changed(above);
  return shop.model.fits(state, i) && (!in_grid || shop.model.fits(state, above));
}

}  // namespace vug::fit
