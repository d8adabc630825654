// SPDX-License-Identifier: Apache-2.0
// The nearest points of a mesh of triangles and quads.
#pragma once

#include <vug/mesh/box_tree.h>
#include <vug/meshing/faces.h>

namespace vug::meshing {

/// Quads are split from their first corner. The mesh must outlive this object.
class NearestPolygon {
 public:
  explicit NearestPolygon(const FaceMesh& mesh);

  struct Found {
    Vec3d point;
    const Face* face = nullptr;  ///< Null if the mesh is farther away than the limit.
  };
  /// The point of the mesh nearest to p within `limit` metres. Thread-safe.
  Found find(const Vec3d& p, double limit) const;

 private:
  std::array<Vec3d, 3> triangle(const Face& face, uint32_t half) const;

  const FaceMesh& mesh_;
  mesh::BoxTree boxes_;
};

}  // namespace vug::meshing
