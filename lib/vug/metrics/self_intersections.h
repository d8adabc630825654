// Pairs of triangles of one mesh that meet where they should not.
#pragma once

#include <vug/mesh/mesh.h>

#include <utility>

namespace vug::metrics {

/// The pairs (low, high) in order. Neighbours may share their common corners and edge only:
/// a fold flat onto its neighbour counts. Exact (CGAL's predicates); triangles without area are
/// passed over.
std::vector<std::pair<uint32_t, uint32_t>> self_intersections(const mesh::Mesh& mesh);

}  // namespace vug::metrics
