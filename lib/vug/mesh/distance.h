// Signed distance to a closed triangle mesh, exact up to rounding.
// The nearest triangle comes from a bounding volume hierarchy; the sign from the angle-weighted
// pseudonormal of the nearest feature (baerentzen2005), which is right for any closed, outward
// oriented mesh. A mesh with holes still gets a distance, but its sign flips across the gaps.
#pragma once

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

  /// Error(bad_input) when the mesh has no triangle with an area. Keeps its own copy of what it
  /// needs; copies of this object share it.
  explicit MeshDistance(const Mesh& mesh);

  /// Negative inside; thread-safe.
  double signed_distance(const Vec3d& p) const;
  Closest closest(const Vec3d& p) const;

  /// Box around the surface.
  const Box3d& bounds() const;

 private:
  struct Tree;
  std::shared_ptr<const Tree> tree_;
};

}  // namespace vug::mesh
