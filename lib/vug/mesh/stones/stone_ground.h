// SPDX-License-Identifier: Apache-2.0
// The surface below stones, for questions about heights at points of the plan.
#pragma once

#include <vug/mesh/box_tree.h>
#include <vug/mesh/mesh.h>

namespace vug::mesh {

/// A few triangles of the ground near one stone.
class GroundPatch {
 public:
  struct Face {
    std::array<Vec3d, 3> corners;
    Vec3d across;  ///< Out of the solid, twice the area long.
  };

  GroundPatch(std::vector<Face> faces, std::vector<Vec3d> corners)
      : faces_(std::move(faces)), corners_(std::move(corners)) {}

  /// The height of the highest surface that faces up; -infinity if there is none.
  double floor(double x, double z) const;
  /// The height of the lowest surface that faces down and is above `from`; infinity if there is
  /// none.
  double roof(double x, double z, double from) const;
  /// The corners of the triangles that face up.
  const std::vector<Vec3d>& corners() const { return corners_; }
  /// The mean normal of the triangles that face up; (0, 1, 0) if there are none.
  Vec3d mean_up() const;

 private:
  std::vector<Face> faces_;
  std::vector<Vec3d> corners_;
};

/// The triangles of a mesh in a tree of boxes. The mesh must outlive it.
class StoneGround {
 public:
  explicit StoneGround(const Mesh& mesh);

  /// The triangles that touch a box.
  GroundPatch patch(const Box3d& box) const;

 private:
  const Mesh& mesh_;
  BoxTree tree_;
};

}  // namespace vug::mesh
