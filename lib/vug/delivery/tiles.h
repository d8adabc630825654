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
  int levels = 0;  ///< Levels of detail of each tile of a mesh in addition to the full one.
  std::string usd_format = "usda";  ///< Format of the USD layers: "usda" or "usdc".
};

struct TilesReport {
  std::vector<std::filesystem::path> files;  ///< In the order of writing.
  std::vector<std::string> levels;  ///< Sentences about the triangles and distances of each level.
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
/// interrupted run of the same scene completed are not built again.
///
/// With levels, each tile of a mesh also has MESH_I_J_K_lodN.EXT; see meshing/tile_levels.h. Each
/// level and the full mesh have a USD layer, and assembly.usda or assembly.usdc shows all tiles;
/// see exchange/usd_tiles.h.
///
/// Error(bad_input) with an obstacle, or for tiles that do not exist, or for levels without a mesh
/// on a volume; Error(too_large) if one tile exceeds the memory; Error(io).
TilesReport write_tiles(building::Builder& builder, const std::filesystem::path& folder,
                        const TileOptions& options);

/// The folder of the tiles.
std::filesystem::path tile_folder(const shot::Shot& shot, const std::filesystem::path& folder);

}  // namespace vug::delivery
