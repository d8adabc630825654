// SPDX-License-Identifier: Apache-2.0
// Triangulation of polygons from files.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Appends the triangles of one polygon (at least 3 corner indices, in order) to the mesh. Planar
/// simple polygons keep their shape, including concavities (ear clipping; add_rings beyond 64
/// corners). Self-intersecting polygons become a fan around their first corner.
void add_polygon(Mesh& mesh, const std::vector<uint32_t>& polygon);

/// Appends a polygon with holes: the outer ring first, whose orientation defines the outside,
/// then the holes in either orientation; each ring has at least 3 corners. Regions inside an even
/// number of rings are empty, so a hole may contain an island. Nothing is added if the outer ring
/// has no area. Throws Error(bad_input) if sides cross other than at common corners; the mesh is
/// then unchanged.
void add_rings(Mesh& mesh, const std::vector<std::vector<uint32_t>>& rings);

/// Triangulates rings in the plane, exactly: a constrained Delaunay triangulation. Corners are
/// numbered from 0 over all rings; among corners at one position the first is used. Triangles turn
/// left, from x towards y.
std::vector<Triangle> triangles_of(const std::vector<std::vector<Vec2d>>& rings);

}  // namespace vug::mesh
