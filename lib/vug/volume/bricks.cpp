// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/bricks.h>
#include <vug/volume/crop.h>
#include <vug/volume/openvdb_values.h>

#include <openvdb/tools/Composite.h>
#include <openvdb/tools/Prune.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace vug::volume {
namespace {

using BrickNode = openvdb::FloatTree::RootNodeType::ChildNodeType::ChildNodeType;
using BlockLeaf = BrickNode::ChildNodeType;
static_assert(BrickNode::DIM == kBrickEdge);

constexpr size_t kBlocks = BrickNode::NUM_VALUES;

BrickOrigin brick_origin(const openvdb::Coord& at) { return {at.x(), at.y(), at.z()}; }

Digest constant_block(float value) { return Hasher().add_value(value).finish(); }

bool is_constant(const BlockLeaf& leaf) {
  const float* values = leaf.buffer().data();
  return leaf.isEmpty() && std::all_of(values, values + BlockLeaf::SIZE,
                                       [&](float value) { return value == values[0]; });
}

Digest block_digest(const BlockLeaf& leaf) {
  if (is_constant(leaf)) return constant_block(leaf.buffer().data()[0]);
  Hasher hasher;
  for (openvdb::Index word = 0; word < BlockLeaf::SIZE / 64; ++word)
    hasher.add_value(leaf.valueMask().getWord<uint64_t>(word));
  hasher.add(leaf.buffer().data(), BlockLeaf::SIZE * sizeof(float));
  return hasher.finish();
}

Digest digest_of(const std::vector<Digest>& blocks) {
  return Hasher().add(blocks.data(), blocks.size() * sizeof(Digest)).finish();
}

/// The digest of a brick; nothing if all of it is outside.
std::optional<Digest> brick_digest(const BrickNode& brick, float background) {
  const Digest outside = constant_block(background);
  std::vector<Digest> blocks(kBlocks);
  bool any = false;
  for (openvdb::Index n = 0; n < kBlocks; ++n) {
    const auto* leaf = brick.isChildMaskOn(n) ? brick.getTable()[n].getChild() : nullptr;
    blocks[n] = leaf ? block_digest(*leaf) : constant_block(brick.getTable()[n].getValue());
    any = any || blocks[n] != outside;
  }
  return any ? std::optional(digest_of(blocks)) : std::nullopt;
}

}  // namespace

std::map<BrickOrigin, Digest> brick_digests(const LevelSet& level_set) {
  const openvdb::FloatTree& tree = floats(level_set).tree();
  std::vector<const BrickNode*> bricks;
  tree.getNodes(bricks);
  std::vector<std::optional<Digest>> digests(bricks.size());
  parallel_for(bricks.size(),
               [&](size_t i) { digests[i] = brick_digest(*bricks[i], tree.background()); });
  std::map<BrickOrigin, Digest> out;
  for (size_t i = 0; i < bricks.size(); ++i)
    if (digests[i]) out.emplace(brick_origin(bricks[i]->origin()), *digests[i]);
  const Digest inside = digest_of(std::vector<Digest>(kBlocks, constant_block(-tree.background())));
  auto tile = tree.cbeginValueAll();
  tile.setMaxDepth(openvdb::FloatTree::ValueAllCIter::LEAF_DEPTH - 2);  // Larger than blocks.
  for (; tile; ++tile) {
    if (!(*tile < 0)) continue;
    openvdb::CoordBBox box;
    tile.getBoundingBox(box);
    for (int x = box.min().x(); x <= box.max().x(); x += kBrickEdge)
      for (int y = box.min().y(); y <= box.max().y(); y += kBrickEdge)
        for (int z = box.min().z(); z <= box.max().z(); z += kBrickEdge)
          out.emplace(BrickOrigin{x, y, z}, inside);
  }
  return out;
}

LevelSet joined(const std::vector<LevelSet>& tiles) {
  if (tiles.empty()) throw Error(ErrorCode::bad_input, "a level set needs at least one tile");
  const openvdb::FloatGrid& first = floats(tiles[0]);
  const auto grid = openvdb::FloatGrid::create(first.background());
  grid->setTransform(first.transform().copy());
  grid->setGridClass(openvdb::GRID_LEVEL_SET);
  for (const LevelSet& tile : tiles) {
    const openvdb::FloatGrid& own = floats(tile);
    if (own.background() != grid->background() || own.transform() != grid->transform())
      throw Error(ErrorCode::bad_input, "the tiles of a level set differ in their voxels or bands",
                  {}, "join tiles that were built with the same settings");
    const auto part = own.deepCopy();
    openvdb::tools::csgUnion(*grid, *part, false);
  }
  openvdb::tools::prune(grid->tree());
  return LevelSet(wrap(grid));
}

LevelSet cropped(const LevelSet& level_set, const LatticeBox& box) {
  const auto grid = floats(level_set).deepCopy();
  crop(*grid, box);
  return LevelSet(wrap(grid));
}

}  // namespace vug::volume
