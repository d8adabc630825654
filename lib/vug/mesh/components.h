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

/// The bounding boxes of the components; `component_of` is the result of face_components.
std::vector<Box3d> component_bounds(const Mesh& mesh, const std::vector<uint32_t>& component_of);

/// The volumes in cubic metres that the components of a closed mesh enclose, negative for those
/// whose normals point into the enclosed space; `component_of` is the result of face_components.
std::vector<double> component_volumes(const Mesh& mesh, const std::vector<uint32_t>& component_of);

/// The mesh without the components that do not remain; `remains` has one value for each. The other
/// triangles keep their order, normals and attributes.
Mesh remaining(Mesh mesh, const std::vector<uint32_t>& component_of,
               const std::vector<char>& remains);

}  // namespace vug::mesh
