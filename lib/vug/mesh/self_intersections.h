// SPDX-License-Identifier: Apache-2.0
// Self-intersections: pairs of triangles of one mesh that intersect.
#pragma once

#include <vug/mesh/box_tree.h>
#include <vug/mesh/mesh.h>

#include <utility>

namespace vug::mesh {

using FacePair = std::pair<uint32_t, uint32_t>;

/// The pairs (low, high) in order. Neighbours may share only their common corners and edge: a fold
/// that is flat on its neighbour counts as an intersection. Exact (CGAL's predicates); triangles
/// without area are ignored.
std::vector<FacePair> self_intersections(const Mesh& mesh);
/// As above, but only the pairs whose triangles have the same component (see face_components()).
std::vector<FacePair> self_intersections(const Mesh& mesh,
                                         const std::vector<uint32_t>& component_of);

/// The boxes of the triangles.
std::vector<Box3d> triangle_boxes(const Mesh& mesh);

/// As above, but only the pairs that contain one of these faces (ascending). Each item of the tree
/// is a triangle, whose box may be larger than the triangle.
std::vector<FacePair> self_intersections_of(const std::vector<uint32_t>& faces, const Mesh& mesh,
                                            const BoxTree& tree);

}  // namespace vug::mesh
