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

}  // namespace vug::fit
