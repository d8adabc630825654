// Moves vertices to their targets without folding a polygon.
#pragma once

#include <vug/meshing/targets.h>

namespace vug::meshing {

/// Where the vertices went.
struct MoveResult {
  std::vector<Vec3d> points;
  std::vector<char> on_crease;  ///< By vertex.
  size_t shortened_moves = 0;   ///< Vertices that are not at their first target.
};

/// All vertices go to their targets; then those whose polygons fold by it take lesser targets,
/// one vertex at a time where that mends the polygon: the other place on the crease, the surface,
/// a share of the way. Folds that the raw polygons had stay.
MoveResult apply_moves_without_flips(const FaceMesh& raw, const std::vector<Target>& targets,
                                     const field::Field& exact, double voxel,
                                     const Progress& progress);

}  // namespace vug::meshing
