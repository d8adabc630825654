// SPDX-License-Identifier: Apache-2.0
// The polygons between OpenVDB's mesher and the final triangles. Quads are kept until their
// vertices have moved, because the better diagonal is known only then.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/volume/polygons.h>

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace vug::meshing {

/// A triangle or a quad, anticlockwise from outside, from its smallest index.
struct Face {
  std::array<uint32_t, 4> corners{};  ///< The last one of a triangle is 0.
  uint32_t size = 3;
  auto operator<=>(const Face&) const = default;
};

/// In canonical order, which does not depend on the grid around a part of the surface: points by
/// the cells of the lattice that contain them, x before y before z, and faces by their corners.
struct FaceMesh {
  std::vector<Vec3d> points;
  std::vector<Face> faces;
  /// Faces at vertex v: around[first[v] .. first[v + 1]), ascending.
  std::vector<uint32_t> first;
  std::vector<uint32_t> around;

  Vec3d centre(const Face& face) const;
};

/// Removes repeated corners, and faces with fewer than three corners left. `voxel` is the edge of
/// the lattice's cells.
FaceMesh face_mesh(const volume::Polygons& polygons, double voxel);

/// Normal at corner k of the face, not normalised, with the vertices at `points`.
Vec3d corner_normal(const Face& face, uint32_t k, const std::vector<Vec3d>& points);

}  // namespace vug::meshing
