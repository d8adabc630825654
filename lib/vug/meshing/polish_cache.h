// SPDX-License-Identifier: Apache-2.0
// Results of the polish of earlier meshes that a later version of the same solid can use again.
#pragma once

#include <vug/base/lru_cache.h>

#include <atomic>
#include <cstdint>
#include <memory>
#include <utility>

namespace vug::meshing {

/// Groups of points in 8^3 cells of the lattice; each of the five passes of the polish has its own.
struct GroupCounts {
  uint64_t evaluated = 0, reused = 0;
};

/// The results of each pass of the polish for a group of points, by the digest of everything on
/// which they depend: the points, the results of earlier passes around them, the options, and the
/// field restricted to the group. Thread-safe; `polygonize` with a cache has the bytes of
/// `polygonize` without.
class PolishCache {
 public:
  explicit PolishCache(uint64_t max_bytes = uint64_t{256} << 20) : results_(max_bytes) {}

  GroupCounts counts() const { return {evaluated_, reused_}; }
  uint64_t bytes() const { return results_.bytes(); }

  /// Internal to meshing/.
  std::shared_ptr<const void> find(const Digest& key) {
    std::shared_ptr<const void> known = results_.find(key);
    ++(known ? reused_ : evaluated_);
    return known;
  }
  void insert(const Digest& key, std::shared_ptr<const void> results, uint64_t bytes) {
    results_.insert(key, std::move(results), bytes);
  }

 private:
  LruCache<void> results_;
  std::atomic<uint64_t> evaluated_ = 0, reused_ = 0;
};

}  // namespace vug::meshing
