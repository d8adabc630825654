// SPDX-License-Identifier: Apache-2.0
// Compares two meshes with the same triangles, before and after their vertices moved.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// The largest distance that a vertex moved, in metres; 0 for meshes without vertices.
double max_displacement(const Mesh& before, const Mesh& after);

/// The number of triangles whose normal turned by more than 90 degrees. On a surface that was
/// smooth before, these are folds.
size_t flipped_triangles(const Mesh& before, const Mesh& after);

}  // namespace vug::mesh
