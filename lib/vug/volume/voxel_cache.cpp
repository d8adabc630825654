// SPDX-License-Identifier: Apache-2.0
#include <vug/volume/kept_block.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace vug::volume {

KeptBlock::KeptBlock(const Block& from, float contact)
    : inside(from.values[0] < 0), contact_below(std::numeric_limits<float>::infinity()) {
  if (!from.any_active()) return;
  active = std::make_unique<const Block>(from);
  for (const float value : from.values) {
    const float magnitude = std::fabs(value);
    if (magnitude <= contact)
      contact_from = std::max(contact_from, magnitude);
    else
      contact_below = std::min(contact_below, magnitude);
  }
}

std::shared_ptr<const KeptBlock> VoxelCache::find(const Digest& key, float contact) {
  std::shared_ptr<const KeptBlock> known = blocks_.find(key);
  if (known && !(contact >= known->contact_from && contact < known->contact_below)) known = nullptr;
  ++(known ? reused_ : evaluated_);
  return known;
}

void VoxelCache::insert(const Digest& key, std::shared_ptr<const KeptBlock> block) {
  const uint64_t bytes = block->bytes();
  blocks_.insert(key, std::move(block), bytes);
}

}  // namespace vug::volume
