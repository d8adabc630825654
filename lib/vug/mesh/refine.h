// SPDX-License-Identifier: Apache-2.0
// Refinement of a mesh into smaller triangles of the same shape.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// Halves edges longer than `longest` metres until none remain. Triangles that share an edge share
/// its midpoint, so no gap opens. The surface does not change; normals (of unit length) and
/// attributes of new vertices are interpolated. Existing vertices keep their numbers. The result
/// does not depend on the order of a triangle's corners. Throws Error(too_large) if that needs more
/// than `most` triangles.
Mesh refined(Mesh mesh, double longest, size_t most = size_t{1} << 31);

}  // namespace vug::mesh
