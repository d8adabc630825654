// A mesh with smaller triangles of the same shape.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Edges longer than `longest` metres are halved until there are none; triangles that share an edge
/// share its middle, so no gap opens. The surface stays where it is; normals and attributes of new
/// vertices are interpolated, normals of unit length. The vertices of the mesh keep their numbers.
/// The same for any order in which a triangle names its corners. Error(too_large) where that would
/// make more than `most` triangles.
Mesh refined(Mesh mesh, double longest, size_t most = size_t{1} << 31);

}  // namespace vug::mesh
