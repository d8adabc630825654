// SPDX-License-Identifier: Apache-2.0
// Parts of level sets and meshes that later versions of a scene use again.
#pragma once

#include <vug/meshing/polish_cache.h>
#include <vug/volume/voxel_cache.h>

#include <memory>

namespace vug::building {

/// The numbers of parts that were computed and taken from a PartCache.
struct PartCounts {
  volume::BlockCounts blocks;
  meshing::GroupCounts groups;
};

/// Shared by the builders of successive versions. Unlike the store, which has whole products, it
/// serves products of which an edit changes a part. Products have the same bytes with and without.
struct PartCache {
  volume::VoxelCache voxels;
  meshing::PolishCache polish;

  PartCounts counts() const { return {voxels.counts(), polish.counts()}; }
};
using PartCachePtr = std::shared_ptr<PartCache>;

}  // namespace vug::building
