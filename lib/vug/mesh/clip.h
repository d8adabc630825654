// SPDX-License-Identifier: Apache-2.0
// Clips a mesh along an isoline of values at its vertices.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Returns the part of the mesh whose value is at or below the level, by linear interpolation over
/// each triangle (marching triangles); `values` has one number per vertex. Triangles that cross the
/// level are cut along it, and triangles that share an edge share the new vertex on it, so no gap
/// opens between them. Normals and attributes of new vertices are interpolated. The remaining
/// vertices keep their order, and their numbers if all of them remain. A corner that is nearer to
/// the cut than a thousandth of the edge becomes part of the cut, which avoids slivers.
Mesh clip(const Mesh& mesh, const std::vector<float>& values, float level);

}  // namespace vug::mesh
