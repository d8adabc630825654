// How far a mesh has gone from where it was: two meshes of the same triangles.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Metres of the vertex that has gone farthest; 0 for no vertices.
double max_displacement(const Mesh& before, const Mesh& after);

/// Triangles that face away from where they faced: of a surface that was fine, folds.
size_t flipped_triangles(const Mesh& before, const Mesh& after);

}  // namespace vug::mesh
