// SPDX-License-Identifier: Apache-2.0
// Shortens moves of vertices until no triangles intersect or fold, for displacement.h and
// meshing/remove_crossings.h.
#pragma once

#include <vug/mesh/self_intersections.h>

#include <functional>

namespace vug::mesh {

/// Triangles that divide one polygon, whose vertices move back together.
struct PolygonGroups {
  std::vector<uint32_t> first;  ///< The first triangle of each polygon, and their total number.
  /// Called for each polygon one of whose vertices moved back; returns whether it replaced the
  /// polygon's triangles in the mesh by others of the same vertices.
  std::function<bool(uint32_t polygon)> divide;
};

/// Shortens the moves from `before` of the vertices of invalid triangles, which intersect others,
/// are folded or have no area: to a half, a quarter, an eighth, and nothing, until no such triangle
/// is left or none of its vertices is moved. Returns the share that each vertex keeps of its move.
/// The result is the same for any number of threads.
std::vector<float> retreat(const std::vector<Vec3f>& before, Mesh& mesh,
                           const PolygonGroups& groups = {});
/// As above, for a mesh whose self-intersections are known.
std::vector<float> retreat(const std::vector<Vec3f>& before, Mesh& mesh,
                           const std::vector<FacePair>& crossings,
                           const PolygonGroups& groups = {});

}  // namespace vug::mesh
