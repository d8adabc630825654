// SPDX-License-Identifier: Apache-2.0
// Removes connected components below a given size from a mesh.
#pragma once

#include <vug/mesh/mesh.h>

namespace vug::mesh {

struct LargeComponents {
  Mesh mesh;
  size_t removed = 0;  ///< Number of removed components.
};

/// Removes the components (triangles connected by edges) whose bounding box has a diagonal below
/// `smallest` metres: floating crumbs as well as bubbles inside a solid. The largest component
/// always remains. The remaining triangles keep their order, normals and attributes. With 0 the
/// mesh is returned unchanged.
LargeComponents large_components(Mesh mesh, double smallest);

}  // namespace vug::mesh
