// SPDX-License-Identifier: Apache-2.0
// Merging of vertices at equal positions.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// For each position, the index of the first equal one (0 and -0 are equal).
std::vector<uint32_t> first_equal(const std::vector<Vec3f>& positions);

/// Merges vertices at equal positions (the first one's normal and attributes are kept) and removes
/// triangles that become degenerate and unused vertices.
Mesh welded(const Mesh& mesh);

/// Removes the vertices that no triangle uses; the others keep their order.
Mesh without_unused_vertices(const Mesh& mesh);

/// A mesh without vertices and triangles that has the attributes of another one.
Mesh with_attributes_of(const Mesh& mesh);
/// Adds a vertex of a mesh, with its normal and attributes, to one that has the same attributes.
void append_vertex(const Mesh& from, uint32_t vertex, Mesh& to);

}  // namespace vug::mesh
