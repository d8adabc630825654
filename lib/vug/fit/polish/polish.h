// SPDX-License-Identifier: Apache-2.0
// Local refinement of a tree to pixel accuracy: optimises its numbers and removes parts, but adds
// none.
#pragma once

#include <vug/base/progress.h>
#include <vug/fit/move.h>

namespace vug::fit {

struct PolishResult {
  double before = 0, after = 0;  ///< Bits; `after` never exceeds `before`.
  int rounds = 0;                ///< Sweeps until convergence.
};

/// Sweeps over all nodes until no node improves: lines and sizes of grids by dynamic programming
/// over all positions, the cheapest grid type that draws the same, and exhaustive search over the
/// edges of doors and elements and the lines between parts. Parts that save no bits are removed.
/// Stops early if cancelled.
PolishResult polish(const MoveContext& context, const Evidence& evidence, TreeState& state,
                    Progress& progress = Progress::none());

/// Refines the grid below node i: each of its columns and rows and the sizes of its windows.
/// Returns whether that saved bits; otherwise the state is unchanged.
bool polish_grid(const MoveContext& context, const Evidence& evidence, TreeState& state, int i);

/// Refines the window kinds of the grid below node i, if its windows may differ: their number,
/// their sizes, and the kind in each cell. Returns as polish_grid.
bool polish_kinds(const MoveContext& context, const Evidence& evidence, TreeState& state, int i);

/// Refines the position of each line of that grid while each cell of the line takes the kind with
/// the largest gain and the sizes of the kinds adapt. Returns as polish_grid.
bool polish_cells(const MoveContext& context, const Evidence& evidence, TreeState& state, int i);

/// Selects the cheapest grid type for node i, which has been rewritten to a grid. Returns as
/// polish_grid.
bool polish_type(const MoveContext& context, TreeState& state, int i);

/// Replaces the state if the other one is valid and cheaper.
bool replace_if_cheaper(const Model& model, TreeState& state, TreeState other);

}  // namespace vug::fit
