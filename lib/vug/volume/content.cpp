// SPDX-License-Identifier: Apache-2.0
// Digest of a grid's content: little-endian bytes of the tree in its own sorted order.
#include <vug/base/parallel.h>
#include <vug/volume/grid_access.h>
#include <vug/volume/openvdb_values.h>
#include <vug/volume/points.h>

#include <sstream>
#include <vector>

namespace vug::volume {
namespace {

template <class GridType>
bool hash_tree(const openvdb::GridBase& base, Hasher& hasher) {
  if (!base.isType<GridType>()) return false;
  const auto& tree = static_cast<const GridType&>(base).tree();
  using Leaf = typename GridType::TreeType::LeafNodeType;
  std::vector<const Leaf*> leaves;
  tree.getNodes(leaves);
  std::vector<Digest> digests(leaves.size());
  parallel_for(
      leaves.size(),
      [&](size_t i) {
        const Leaf& leaf = *leaves[i];
        Hasher own;
        own.add(leaf.origin().data(), 3 * sizeof(openvdb::Int32));
        for (openvdb::Index w = 0; w < Leaf::SIZE / 64; ++w)
          own.add_value(leaf.valueMask().template getWord<uint64_t>(w));
        own.add(leaf.buffer().data(), Leaf::SIZE * sizeof(*leaf.buffer().data()));
        digests[i] = own.finish();
      },
      256);
  hasher.add(digests.data(), digests.size() * sizeof(Digest));
  hasher.add_value(tree.background());
  for (auto tile = tree.cbeginValueAll(); tile; ++tile) {
    if (tile.isVoxelValue()) break;  // Tiles precede voxels.
    openvdb::CoordBBox box;
    tile.getBoundingBox(box);
    const auto value = tile.getValue();
    hasher.add(box.min().data(), 3 * sizeof(openvdb::Int32));
    hasher.add_value(value).add_value(tile.isValueOn());
  }
  return true;
}

}  // namespace

Digest Grid::content() const {
  const openvdb::GridBase& grid = *data_->grid;
  Hasher hasher;
  std::ostringstream transform(std::ios::binary);
  grid.writeTransform(transform);
  hasher.add(grid.type()).add(transform.str());
  if (is_points(*this)) {
    hasher.add_value(digest(points(*this)));
  } else if (!hash_tree<openvdb::FloatGrid>(grid, hasher) &&
             !hash_tree<openvdb::Vec3SGrid>(grid, hasher)) {
    // Other types by their serialised form.
    std::ostringstream bytes(std::ios::binary);
    grid.writeTopology(bytes);
    grid.writeBuffers(bytes);
    hasher.add(bytes.str());
  }
  return hasher.finish();
}

}  // namespace vug::volume
