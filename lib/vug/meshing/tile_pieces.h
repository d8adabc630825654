// SPDX-License-Identifier: Apache-2.0
// Connected components of a surface that is divided into tiles. Only the edges at the borders of
// tiles are kept in memory, so that a surface may be larger than the memory.
#pragma once

#include <vug/base/vec.h>
#include <vug/meshing/tile_mesh.h>

#include <cstdint>
#include <vector>

namespace vug::meshing {

class TilePieces {
 public:
  /// Adds the next tile; the tiles are numbered from 0.
  void add(const TileMesh& tile, const volume::LatticeBox& box);

  struct Large {
    /// Whether each component of a tile belongs to a piece that remains; tile by tile.
    /// The components are those of mesh::face_components.
    std::vector<std::vector<char>> remains;
    size_t removed = 0;  ///< Number of pieces that do not remain.
  };
  /// The pieces whose bounding boxes have a diagonal of at least `smallest` metres; the largest
  /// piece always remains. The same pieces as those of mesh::large_components.
  Large large(double smallest) const;

 private:
  /// An edge that may have triangles in several tiles.
  struct BorderEdge {
    LatticeKey low, high;
    uint32_t component = 0;  ///< Counted over all tiles.
    auto operator<=>(const BorderEdge&) const = default;
  };
  std::vector<uint32_t> first_ = {0};  ///< The first component of each tile, and their total.
  std::vector<Box3d> boxes_;
  std::vector<BorderEdge> borders_;
};

}  // namespace vug::meshing
