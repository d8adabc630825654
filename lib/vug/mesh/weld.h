// Vertices at the same place made one.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// For each position the index of the first one that equals it (0 and -0 are equal).
std::vector<uint32_t> first_equal(const std::vector<Vec3f>& positions);

/// A mesh whose vertices at equal positions are one (the first one's normal and attributes
/// stay), without the triangles that lose a corner by it and without unused vertices.
Mesh welded(const Mesh& mesh);

/// A mesh without the vertices that no triangle uses; the others keep their order.
Mesh without_unused_vertices(const Mesh& mesh);

}  // namespace vug::mesh
