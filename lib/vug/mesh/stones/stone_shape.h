// SPDX-License-Identifier: Apache-2.0
// The convex hull of a stone, by which it touches the ground and other stones.
#pragma once

#include <vug/mesh/mesh.h>

#include <optional>

namespace vug::mesh {

/// A convex body around its centre of mass.
struct StoneShape {
  /// A plane: outward . p = offset.
  struct Face {
    Vec3d outward;      ///< Unit length.
    double offset = 0;  ///< Above 0, metres.
  };
  std::vector<Vec3d> corners;  ///< Relative to the centre of mass, metres.
  std::vector<Face> faces;     ///< The body is the intersection of their half-spaces.
  std::vector<Vec3d> probes;   ///< The corners, and points between them on long edges and faces.
  Vec3d centre{0.0};           ///< The centre of mass in the space of the mesh.
  double radius = 0;           ///< Distance of the farthest corner from the centre of mass.
  double diameter = 0;         ///< The diameter of the ball with the volume of the mesh, metres.
};

/// The hull of the outermost vertices in 96 directions, inside the mesh's own hull by at most 4 %
/// of the diameter. The mass is uniform. Error(bad_input) for a mesh that encloses no volume.
StoneShape stone_shape(const Mesh& mesh);

/// A range of heights.
struct Heights {
  double low = 0, high = 0;
};

/// A stone of a shape in the scene: p -> centre + turn(scale p).
struct StonePose {
  Vec3d centre{0.0};                         ///< The centre of mass.
  Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};  ///< The turned axes, of unit length.
  double scale = 1;

  Vec3d offset(const Vec3d& corner) const {
    return (x * corner.x + y * corner.y + z * corner.z) * scale;
  }
  /// The pose rotated about its centre by the length of the vector in radians.
  StonePose turned(const Vec3d& rotation) const;
};

/// The lowest and the highest point of the stone on a vertical line; nothing if they do not meet.
std::optional<Heights> heights_at(const StoneShape& shape, const StonePose& pose, double x,
                                  double z);

}  // namespace vug::mesh
