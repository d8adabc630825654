// SPDX-License-Identifier: Apache-2.0
// Symmetry detection: grids whose columns repeat or mirror a part of themselves, and the production
// that describes that part once. Lines of the unfolded grid may deviate by a few pixels.
#pragma once

#include <vug/fit/move.h>

namespace vug::fit {

/// Folds a grid below some node into one part that is mirrored or repeated (`op`), or unfolds it.
/// The grid has windows of one kind and no door.
bool fold_or_unfold(const MoveContext& context, TreeState& state, Op op, Choices& forward,
                    Choices& back);

}  // namespace vug::fit
