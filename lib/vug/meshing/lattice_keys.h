// SPDX-License-Identifier: Apache-2.0
// The places of vertices and triangles in the canonical order of a mesh, by which the tiles of a
// surface are joined.
#pragma once

#include <vug/meshing/faces.h>

#include <array>
#include <compare>
#include <cstdint>
#include <vector>

namespace vug::meshing {

/// The place of a vertex: the cell of the lattice that contains it before the polish, and its
/// number among the vertices of that cell. Tiles with a vertex in common agree about its key.
struct LatticeKey {
  std::array<int32_t, 3> cell{};
  uint32_t number = 0;
  auto operator<=>(const LatticeKey&) const = default;
};

struct LatticeKeys {
  std::vector<LatticeKey> vertices;  ///< Ascending.
  /// For each triangle the vertex at which its polygon begins, which is the first one of the
  /// polygon's corners; ascending.
  std::vector<uint32_t> begins;
};

/// The keys of the mesh whose triangles divide these polygons, without unused vertices. `voxel` is
/// the edge of the lattice's cells.
LatticeKeys lattice_keys(const FaceMesh& polygons, double voxel);

}  // namespace vug::meshing
