// The last pixels of a tree: its numbers are made the best there are; parts only go.
#pragma once

#include <vug/base/progress.h>
#include <vug/fit/move.h>

namespace vug::fit {

struct PolishResult {
  double before = 0, after = 0;  ///< Bits; never more after than before.
  int rounds = 0;                ///< Until nothing changed any more.
};

/// Turns over all nodes until none gets better: lines and sizes of grids by dynamic programming
/// over all places, the cheapest type of a grid that draws the same, edges of doors and elements
/// and the lines between parts by trying all places; what saves no bits is taken back. Stops in
/// between when told to.
PolishResult polish(const MoveContext& context, const Evidence& evidence, TreeState& state,
                    Progress& progress = Progress::none());

/// Of the grid below node i: each of its columns and rows and the sizes of its windows. Whether
/// that saved bits; else the state stays as it is.
bool polish_grid(const MoveContext& context, const Evidence& evidence, TreeState& state, int i);

/// Of the grid below node i, if its windows may differ: how many kinds of windows it has, their
/// sizes and which of them stands in each cell. Likewise.
bool polish_kinds(const MoveContext& context, const Evidence& evidence, TreeState& state, int i);

/// Likewise where each of its lines stands, as each cell of the line becomes the kind that gains
/// most there and sizes of kinds follow.
bool polish_cells(const MoveContext& context, const Evidence& evidence, TreeState& state, int i);

/// Of node i, which has been rewritten to a grid: the cheapest type of grid. Likewise.
bool polish_type(const MoveContext& context, TreeState& state, int i);

/// Takes the other state where it is one and cheaper.
bool replace_if_cheaper(const Model& model, TreeState& state, TreeState other);

}  // namespace vug::fit
