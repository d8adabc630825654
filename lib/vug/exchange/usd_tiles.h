// SPDX-License-Identifier: Apache-2.0
// USD layers of a surface that is divided into tiles: one layer for each level of detail of a tile,
// and one that shows all tiles and loads none of them until it is asked to.
#pragma once

#include <vug/exchange/assembly.h>

#include <filesystem>
#include <string>
#include <vector>

namespace vug::exchange {

/// A tile in the layer of all tiles.
struct UsdTile {
  struct Level {
    std::string file;     ///< Its layer, in the folder of the layer of all tiles.
    double distance = 0;  ///< From the full mesh, in metres.
  };
  std::string name;
  Box3d bounds;               ///< The bounding box of the full mesh.
  std::vector<Level> levels;  ///< The full mesh and the coarser ones; at least one.
  mesh::Mesh proxy;           ///< Shown before the tile is loaded.
};

/// A mesh of at most about `triangles` triangles with a subset of the vertices that shows roughly
/// where the mesh is: vertices are merged in the cells of a grid (meshoptimizer; Rossignac and
/// Borrel 1993, "Multi-resolution 3D approximations for rendering complex scenes", cite
/// rossignac1993). The bounding box if nothing remains. Without attributes.
mesh::Mesh coarse_hull(const mesh::Mesh& mesh, size_t triangles);

/// Writes the layer of one level of one tile. Its purpose is "render". Throws Error(io).
void write_usd_tile(const mesh::Mesh& mesh, const Provenance& provenance,
                    const std::filesystem::path& file);

/// Writes the layer of all tiles: a prim for each tile with the level as a payload, its boxes as
/// `extentsHint` and its proxy. Tiles of several levels have the variant set `levelOfDetail` with
/// "full", "lod1", ..., and the distance of a level as `vug:distance`. Throws Error(io).
void write_usd_tiles(const std::string& name, const std::vector<UsdTile>& tiles,
                     const Provenance& provenance, const std::filesystem::path& file);

}  // namespace vug::exchange
