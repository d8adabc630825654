// SPDX-License-Identifier: Apache-2.0
// Moves vertices to their targets without folding a polygon.
#pragma once

#include <vug/meshing/targets.h>

namespace vug::meshing {

/// The vertices after the moves.
struct MoveResult {
  std::vector<Vec3d> points;
  std::vector<char> on_crease;  ///< Per vertex.
  size_t shortened_moves = 0;   ///< Vertices that did not reach their first target.
};

/// Moves all vertices to their targets. Vertices whose polygons fold then fall back to
/// alternatives, one vertex at a time where that is sufficient: the other point on the crease, the
/// surface, or a fraction of the move. Folds of the raw polygons remain.
MoveResult apply_moves_without_flips(const FaceMesh& raw, const std::vector<Target>& targets,
                                     const field::Field& exact, double voxel,
                                     const PolishPasses& passes, const Progress& progress);

}  // namespace vug::meshing
