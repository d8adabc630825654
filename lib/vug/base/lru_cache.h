// SPDX-License-Identifier: Apache-2.0
// A table of shared values by digest with a limited size, which drops the values that were not used
// for the longest time.
#pragma once

#include <vug/base/hash.h>

#include <cstdint>
#include <list>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <utility>

namespace vug {

/// Thread-safe. The callers state the sizes of values; the table itself does not count.
template <class T>
class LruCache {
 public:
  explicit LruCache(uint64_t max_bytes) : max_bytes_(max_bytes) {}

  /// The value of the key, or null.
  std::shared_ptr<const T> find(const Digest& key) {
    const std::lock_guard lock(mutex_);
    const auto found = entries_.find(key);
    if (found == entries_.end()) return nullptr;
    order_.splice(order_.begin(), order_, found->second);
    return found->second->value;
  }

  /// Replaces the value of the key. A value that is larger than the table is not kept.
  void insert(const Digest& key, std::shared_ptr<const T> value, uint64_t bytes) {
    const std::lock_guard lock(mutex_);
    if (const auto known = entries_.find(key); known != entries_.end()) erase(known->second);
    order_.push_front({key, std::move(value), bytes});
    entries_.emplace(key, order_.begin());
    bytes_ += bytes;
    while (bytes_ > max_bytes_) erase(std::prev(order_.end()));
  }

  uint64_t bytes() const {
    const std::lock_guard lock(mutex_);
    return bytes_;
  }

 private:
  struct Entry {
    Digest key;
    std::shared_ptr<const T> value;
    uint64_t bytes = 0;
  };
  struct DigestHash {
    size_t operator()(const Digest& digest) const { return static_cast<size_t>(digest.low); }
  };
  using Order = std::list<Entry>;

  void erase(typename Order::iterator entry) {
    bytes_ -= entry->bytes;
    entries_.erase(entry->key);
    order_.erase(entry);
  }

  const uint64_t max_bytes_;
  mutable std::mutex mutex_;
  Order order_;  ///< The last used value first.
  std::unordered_map<Digest, typename Order::iterator, DigestHash> entries_;
  uint64_t bytes_ = 0;
};

}  // namespace vug
