// SPDX-License-Identifier: Apache-2.0
// The part of a surface that belongs to one tile of the lattice. Each polygon belongs to the tile
// with the cell of its first corner, so that the tiles have every triangle once; vertices on their
// borders are in several tiles, with the same bits.
#pragma once

#include <vug/mesh/mesh.h>
#include <vug/meshing/lattice_keys.h>
#include <vug/volume/voxelize.h>

#include <string_view>
#include <vector>

namespace vug::meshing {

/// Steps of the lattice around a tile that must be meshed with it, because the repairs of the
/// polish look at their surroundings.
constexpr int kMeshApron = 24;

struct TileMesh {
  mesh::Mesh mesh;   ///< In canonical order.
  LatticeKeys keys;  ///< The keys of its vertices and triangles.
};

/// The part in a tile of a surface that was meshed with the apron.
TileMesh tile_mesh(const mesh::Mesh& surface, const LatticeKeys& keys,
                   const volume::LatticeBox& tile);

/// The surface that consists of the tiles, which may be in any order: the mesh that `polygonize`
/// makes of the whole. All tiles need the same attributes.
mesh::Mesh joined(const std::vector<TileMesh>& tiles);

/// The attribute that stores the keys of vertices in files: the cell relative to the tile, and the
/// number.
inline constexpr std::string_view kLatticeKey = "lattice_key";
void add_key_attribute(TileMesh& tile, const volume::LatticeBox& box);
/// The keys of the vertices of a mesh that has the attribute, without those of its polygons.
LatticeKeys keys_of_attribute(const mesh::Mesh& mesh, const volume::LatticeBox& box);

}  // namespace vug::meshing
