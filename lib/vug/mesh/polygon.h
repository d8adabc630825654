// Polygons of files cut into triangles.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Appends the triangles of one polygon (corner indices in order, at least 3) to the mesh.
/// Planar simple polygons keep their shape, dents included (ear clipping, beyond 64 corners
/// add_rings); those that cross themselves are fanned from their first corner.
void add_polygon(Mesh& mesh, const std::vector<uint32_t>& polygon);

/// The same for a polygon with holes: the outer ring first, whose turn says what is outside, then
/// the holes, turned either way; each of at least 3 corners. What lies in an even number of rings
/// is left out, so a hole may hold an island. Nothing is added where the outer ring has no area.
/// Error(bad_input) where sides cross, but for common corners; the mesh is then as before.
void add_rings(Mesh& mesh, const std::vector<std::vector<uint32_t>>& rings);

/// The same in the plane, exactly: constrained Delaunay triangles of corners that are counted over
/// all rings from 0; of those in one place the first. They turn to the left, from x towards y.
std::vector<Triangle> triangles_of(const std::vector<std::vector<Vec2d>>& rings);

}  // namespace vug::mesh
