// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/mesh/components.h>
#include <vug/mesh/topology.h>
#include <vug/meshing/tile_pieces.h>

#include <algorithm>

namespace vug::meshing {
namespace {

/// A polygon of another tile extends by at most one cell from its first corner, so it has no
/// vertex in a cell that is farther than that from the faces of the tile.
bool is_near_border(const LatticeKey& key, const volume::LatticeBox& box) {
  const volume::LatticeBox inner(box.min + Vec3i(2), box.max - Vec3i(2));
  return !inner.intersects(Vec3i(key.cell[0], key.cell[1], key.cell[2]));
}

}  // namespace

void TilePieces::add(const TileMesh& tile, const volume::LatticeBox& box) {
  const mesh::Edges edges = mesh::find_edges(tile.mesh);
  const std::vector<uint32_t> component_of = mesh::face_components(tile.mesh, edges);
  const auto first = static_cast<uint32_t>(boxes_.size());
  for (const Box3d& each : mesh::component_bounds(tile.mesh, component_of)) boxes_.push_back(each);
  first_.push_back(static_cast<uint32_t>(boxes_.size()));
  for (const mesh::Edge& edge : edges.edges) {
    const LatticeKey &low = tile.keys.vertices[edge.low], &high = tile.keys.vertices[edge.high];
    if (is_near_border(low, box) || is_near_border(high, box))
      borders_.push_back({low, high, first + component_of[edges.half_edges[edge.begin] / 3]});
  }
}

TilePieces::Large TilePieces::large(double smallest) const {
  std::vector<BorderEdge> borders = borders_;
  std::sort(borders.begin(), borders.end());
  DisjointSets<uint32_t> pieces(boxes_.size());
  for (size_t i = 1; i < borders.size(); ++i)
    if (borders[i].low == borders[i - 1].low && borders[i].high == borders[i - 1].high)
      pieces.join(borders[i].component, borders[i - 1].component);
  std::vector<Box3d> boxes(boxes_.size());
  for (uint32_t i = 0; i < boxes_.size(); ++i) boxes[pieces.root(i)].extendBy(boxes_[i]);
  const auto square = [&](uint32_t piece) { return boxes[piece].size().dot(boxes[piece].size()); };
  double largest = 0;
  for (uint32_t i = 0; i < boxes_.size(); ++i)
    if (pieces.root(i) == i) largest = std::max(largest, square(i));
  const double enough = std::min(smallest * smallest, largest);
  Large out;
  for (size_t tile = 0; tile + 1 < first_.size(); ++tile) {
    auto& remains = out.remains.emplace_back();
    for (uint32_t i = first_[tile]; i < first_[tile + 1]; ++i) {
      const uint32_t piece = pieces.root(i);
      remains.push_back(smallest <= 0 || square(piece) >= enough ? 1 : 0);
      out.removed += piece == i && !remains.back() ? 1 : 0;
    }
  }
  return out;
}

}  // namespace vug::meshing
