// Grids that say the same of several parts of an area, and the symmetry or repetition that says it
// once. Lines of the unfolded grid may be off by a little.
#pragma once

#include <vug/fit/move.h>

namespace vug::fit {

/// How the columns of a part come again in the whole area.
struct Fold {
  Op op = Op::mirror;
  int times = 2;  ///< How often the part is there.
  /// Where a window, in a part's column that begins at x and of that width, begins when the part
  /// comes again for the time `again` > 0.
  int place(int room, int again, int x, int width) const;
  int part_width(int room) const { return room / times; }
};

/// Folds the grid below node i, whose windows are all of one kind and which has no door; or unfolds
/// it again. False where it does not fit together.
bool fold(const Workshop& shop, State& state, int i, int production, const Fold& fold,
          Choices& forward, Choices& back);
bool unfold(const Workshop& shop, State& state, int i, const Fold& fold, Choices& forward,
            Choices& back);

/// The production of node i to one part by that operation, if that part can be a grid like the
/// one below node i; -1 otherwise.
int folded_way(const Workshop& shop, const State& state, int i, Op op);
/// Whether node i has been rewritten to a grid with windows of one kind and no door.
bool can_fold(const Workshop& shop, const State& state, int i);
/// Whether node i has been rewritten to one part by that operation, and that can be unfolded.
bool can_unfold(const Workshop& shop, const State& state, int i, Op op);

}  // namespace vug::fit
