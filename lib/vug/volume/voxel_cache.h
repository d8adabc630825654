// SPDX-License-Identifier: Apache-2.0
// Voxels of earlier level sets that a later version of the same solid can use again.
#pragma once

#include <vug/base/lru_cache.h>

#include <atomic>
#include <cstdint>
#include <memory>

namespace vug::volume {

struct BlockCounts {
  uint64_t evaluated = 0, reused = 0;
};

struct KeptBlock;

/// The voxels of blocks of 8^3 near the surface, before the ends of bands are trimmed, by the
/// digest of everything on which they depend: the expression restricted to the block, relative to
/// the middle of its brick, and the settings of the band. Thread-safe; `voxelize` with a cache has
/// the bytes of `voxelize` without.
class VoxelCache {
 public:
  explicit VoxelCache(uint64_t max_bytes = uint64_t{512} << 20) : blocks_(max_bytes) {}

  BlockCounts counts() const { return {evaluated_, reused_}; }
  uint64_t bytes() const { return blocks_.bytes(); }

  /// Internal to volume/: the voxels of the key, if they are the same for this distance of contact
  /// (see contact.h), or null.
  std::shared_ptr<const KeptBlock> find(const Digest& key, float contact);
  /// Internal to volume/: keeps voxels that were evaluated.
  void insert(const Digest& key, std::shared_ptr<const KeptBlock> block);

 private:
  LruCache<KeptBlock> blocks_;
  std::atomic<uint64_t> evaluated_ = 0, reused_ = 0;
};

}  // namespace vug::volume
