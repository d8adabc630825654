// Grids that say the same of several parts of an area, and the symmetry or repetition that says it
// once. Lines of the unfolded grid may be off by a little.
#pragma once

#include <vug/fit/move.h>

namespace vug::fit {

/// Folds a grid below some node into one part that is there by `op`, mirror or repeat, or unfolds
/// it again. The grid has windows of one kind and no door.
bool fold_or_unfold(const MoveContext& context, TreeState& state, Op op, Choices& forward,
                    Choices& back);

}  // namespace vug::fit
