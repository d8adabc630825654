// SPDX-License-Identifier: Apache-2.0
// Internal to volume/: the voxels of a block, as a VoxelCache keeps them.
#pragma once

#include <vug/volume/block.h>
#include <vug/volume/voxel_cache.h>

namespace vug::volume {

struct KeptBlock {
  /// `contact`: the distance of contact with which the block was evaluated.
  KeptBlock(const Block& from, float contact);

  std::unique_ptr<const Block> active;  ///< Null: no voxel is active.
  bool inside = false;                  ///< The side of a block without active voxels.
  /// Values up to the distance of contact count as inside. The voxels are the same for distances
  /// from `contact_from` to below `contact_below`, because no value is between them.
  float contact_from = 0, contact_below = 0;

  uint64_t bytes() const { return sizeof(KeptBlock) + (active ? sizeof(Block) : 0); }
};

}  // namespace vug::volume
