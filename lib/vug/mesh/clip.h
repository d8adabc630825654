// A mesh cut along a contour of numbers at its vertices.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// What lies at or below the level, by linear interpolation over each triangle (marching
/// triangles); `values` has one number for each vertex. Triangles across the level are cut along
/// it, and those that share an edge share the new vertex on it too, so no gap opens between them.
/// Normals and attributes of new vertices are interpolated. Vertices that stay keep their order,
/// and their numbers where all stay; a corner that the cut would come nearer to than a thousandth
/// of the edge is taken for the cut itself, so no slivers come about.
Mesh clip(const Mesh& mesh, const std::vector<float>& values, float level);

}  // namespace vug::mesh
