// SPDX-License-Identifier: Apache-2.0
// Signed distance to a closed triangle mesh, exact up to rounding. A bounding volume hierarchy
// finds the nearest triangle; the angle-weighted pseudonormal of the nearest feature
// (baerentzen2005) gives the sign, which is correct for any closed, outward-oriented mesh. A mesh
// with holes also gets a distance, but its sign flips across the gaps.
#pragma once

#include <vug/base/hash.h>
#include <vug/mesh/mesh.h>

namespace vug::mesh {

class MeshDistance {
 public:
  /// The nearest point of the surface.
  struct Closest {
    Vec3d point;        ///< On the surface, metres.
    double distance{};  ///< Unsigned, metres.
    uint32_t triangle{};
    Vec3d normal;  ///< Unit pseudonormal of the nearest face, edge or vertex.
  };

  /// Throws Error(bad_input) if no triangle of the mesh has an area. The object keeps its own
  /// copy of the data it needs; copies of the object share it.
  explicit MeshDistance(const Mesh& mesh);

  /// Signed distance in metres, negative inside. Thread-safe.
  double signed_distance(const Vec3d& p) const;
  Closest closest(const Vec3d& p) const;

  /// The bounding box of the surface.
  const Box3d& bounds() const;
  /// Identifies the triangles, in their order.
  Digest digest() const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace vug::mesh
