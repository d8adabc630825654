// SPDX-License-Identifier: Apache-2.0
#include <vug/mesh/hausdorff.h>
#include <vug/mesh/simplify.h>
#include <vug/meshing/tile_levels.h>

#include <algorithm>

namespace vug::meshing {

std::vector<TileLevel> tile_levels(const mesh::Mesh& tile, int count, Progress& progress) {
  constexpr size_t kFewest = 4;  // The triangles of the smallest solid.
  std::vector<TileLevel> out;
  if (count <= 0 || tile.triangles.empty()) return out;
  progress.begin("levels of detail", static_cast<uint64_t>(count));
  mesh::Simplifier simplifier(tile);
  // Each edge of the border has a triangle of its own in all levels.
  const size_t fewest = std::max(kFewest, 2 * simplifier.border_edges());
  for (int i = 0; i < count; ++i) {
    progress.check();
    const size_t before = simplifier.triangles(), wanted = before / 4;
    if (wanted < fewest) break;
    simplifier.reduce_to(wanted);
    if (4 * simplifier.triangles() > 3 * before) break;
    TileLevel& level = out.emplace_back();
    level.mesh = simplifier.mesh();
    level.distance = mesh::hausdorff_bound(tile, level.mesh);
    progress.advance();
  }
  progress.end();
  return out;
}

}  // namespace vug::meshing
