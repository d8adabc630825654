// SPDX-License-Identifier: Apache-2.0
// Writes the level sets and meshes of a shot as tiles, one after the other, so that they may be
// larger than the memory.
#pragma once

#include <vug/building/builder.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::delivery {

struct TileOptions {
  int edge = 1024;          ///< Edge of a tile in voxels; a multiple of 8, at least 64.
  std::vector<Vec3i> only;  ///< The tiles to write, without an index; empty: all tiles.
};

/// The reason why the products of the shot cannot be written as tiles; empty if they can: there are
/// no cells, and all volumes are made of fields and have no exact distances.
std::string obstacle_to_tiles(const shot::Shot& shot);

/// Writes into `folder`/NAME.tiles: VOLUME_I_J_K.vdb and MESH_I_J_K.EXT for the tiles that the
/// surface crosses, and index.json, which lists them. Tile (I, J, K) has the voxels from
/// (I, J, K) * edge to (I + 1, J + 1, K + 1) * edge - 1 of the lattice through the origin. Its
/// files have the same bytes whichever tiles are written, but for pieces of meshes that are removed
/// because of their size. Each triangle is in one tile. Vertices on borders have the same positions
/// in all of their tiles, and the attribute `lattice_key`; see meshing/tile_mesh.h. Tiles that an
/// interrupted run of the same scene completed are not built again. Returns the
/// paths in the order of writing. Error(bad_input) with an obstacle, or for tiles that do not
/// exist; Error(too_large) if one tile exceeds the memory; Error(io).
std::vector<std::filesystem::path> write_tiles(building::Builder& builder,
                                               const std::filesystem::path& folder,
                                               const TileOptions& options);

/// The folder of the tiles.
std::filesystem::path tile_folder(const shot::Shot& shot, const std::filesystem::path& folder);

}  // namespace vug::delivery
