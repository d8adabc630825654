// SPDX-License-Identifier: Apache-2.0
// Vertex normals from the adjacent triangles.
#pragma once

#include <vug/mesh/fans.h>

namespace vug::mesh {

/// Angle at corner k of a triangle in radians; 0 if an edge at the corner has no length.
double corner_angle(const std::array<Vec3d, 3>& triangle, int k);

/// Unit normals weighted by the angles of the triangles at each vertex (thurmer1998), which do not
/// depend on how a face is triangulated. Vertices without triangles get (0, 1, 0).
std::vector<Vec3f> vertex_normals(const Mesh& mesh);

/// Angle-weighted sums of normals in double precision, without normalisation: the vertex
/// pseudonormals of baerentzen2005.
std::vector<Vec3d> vertex_pseudonormals(const Mesh& mesh);
/// That of one vertex, with the same bits.
Vec3d vertex_pseudonormal(const Mesh& mesh, const Fans& fans, uint32_t vertex);

}  // namespace vug::mesh
