// SPDX-License-Identifier: Apache-2.0
// Levels of detail of the tiles of a surface, which fit together in any mix.
#pragma once

#include <vug/base/progress.h>
#include <vug/mesh/mesh.h>

#include <vector>

namespace vug::meshing {

/// A simplified mesh of a tile.
struct TileLevel {
  mesh::Mesh mesh;
  /// No point of either mesh is farther than this from the other one, in metres: a bound of the
  /// Hausdorff distance from the full mesh; see mesh/hausdorff.h.
  double distance = 0;
};

/// At most `count` levels of the mesh of a tile, from fine to coarse, each with about a quarter of
/// the triangles of the previous one. The vertices and edges on the border of the tile are the same
/// in all levels; see mesh/simplify.h. Therefore tiles of a closed manifold are closed in any mix
/// of levels. There are fewer levels where the border prevents more: the triangles at the border
/// must be at most about half of those of a level, and a level has at most three quarters of the
/// triangles of the previous one. The vertices keep their attributes, including lattice keys.
std::vector<TileLevel> tile_levels(const mesh::Mesh& tile, int count,
                                   Progress& progress = Progress::none());

}  // namespace vug::meshing
