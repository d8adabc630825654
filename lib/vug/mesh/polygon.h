// Polygons of files cut into triangles.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Appends the triangles of one polygon (corner indices in order, at least 3) to the mesh.
/// Planar simple polygons keep their shape, dents included (ear clipping); polygons of more than
/// 64 corners, and those that cross themselves, are fanned from their first corner.
void add_polygon(Mesh& mesh, const std::vector<uint32_t>& polygon);

}  // namespace vug::mesh
