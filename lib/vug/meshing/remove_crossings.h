// SPDX-License-Identifier: Apache-2.0
// Takes moves of vertices back where sheets of the surface cross.
#pragma once

#include <vug/meshing/apply_moves_without_flips.h>

namespace vug::meshing {

/// Shortens the moves of the vertices of triangles that intersect others or have no area: to a
/// half, a quarter, and nothing, until no such triangle is left, or all its vertices are at their
/// raw positions, where polygons of a level set do not intersect. Quads whose vertices are at their
/// raw positions are split along the shorter diagonal. `mesh` has the moved vertices and the
/// triangles of `split_quads`. The result is the same for any number of threads.
void remove_crossings(const FaceMesh& raw, MoveResult& moved, mesh::Mesh& mesh);

}  // namespace vug::meshing
