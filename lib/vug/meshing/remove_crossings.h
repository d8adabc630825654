// SPDX-License-Identifier: Apache-2.0
// Takes moves of vertices back where sheets of the surface cross.
#pragma once

#include <vug/meshing/apply_moves_without_flips.h>

namespace vug::meshing {

/// Shortens moves of vertices until no triangle intersects another, is folded or has no area, as
/// mesh::retreat() does; polygons of a level set with all vertices at their raw positions are
/// valid. Quads with all vertices at their raw positions are split along the shorter diagonal.
/// `mesh` has the moved vertices and the triangles of `split_quads`. The result is the same for any
/// number of threads.
void remove_crossings(const FaceMesh& raw, MoveResult& moved, mesh::Mesh& mesh);

}  // namespace vug::meshing
