// SPDX-License-Identifier: Apache-2.0
// Gradients of mesh attributes; materials/surface.cpp perturbs normals with them (bump mapping).
#pragma once

#include <vug/mesh/mesh.h>

#include <deque>
#include <mutex>
#include <string_view>
#include <vector>

namespace vug::render {

/// Gradients of a mesh's attributes at its vertices, each computed on first use. Thread-safe.
class AttributeGradients {
 public:
  /// Keeps a reference to the mesh.
  explicit AttributeGradients(const mesh::Mesh& mesh);

  /// For each vertex the gradient, per metre, in the mesh's own space; for vector attributes the
  /// gradient of the mean of the components. It is the area-weighted mean over the adjacent
  /// triangles, on each of which the attribute is linear. Null if the mesh has no such attribute.
  const std::vector<Vec3f>* at_vertices(std::string_view attribute) const;

 private:
  struct Gradient {
    std::once_flag once;
    std::vector<Vec3f> at_vertex;
  };
  const mesh::Mesh& mesh_;
  mutable std::deque<Gradient> gradients_;  ///< One per attribute of the mesh.
};

}  // namespace vug::render
