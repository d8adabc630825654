// SPDX-License-Identifier: Apache-2.0
// Self-intersections: pairs of triangles of one mesh that intersect.
#pragma once

#include <vug/mesh/mesh.h>

#include <utility>

namespace vug::metrics {

/// The pairs (low, high) in order. Neighbours may share only their common corners and edge: a fold
/// that is flat on its neighbour counts as an intersection. Exact (CGAL's predicates); triangles
/// without area are ignored.
std::vector<std::pair<uint32_t, uint32_t>> self_intersections(const mesh::Mesh& mesh);

}  // namespace vug::metrics
