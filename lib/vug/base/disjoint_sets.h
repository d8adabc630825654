// SPDX-License-Identifier: Apache-2.0
// Union-find over 0..n-1 with the smallest member of each set as its root, so that results do not
// depend on the order of joins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

namespace vug {

/// Index: an integer type that holds n.
template <class Index = uint32_t>
class DisjointSets {
 public:
  explicit DisjointSets(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), Index(0));
  }

  size_t size() const { return parent_.size(); }

  Index root(Index i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }

  /// Returns true if the two were in different sets.
  bool join(Index a, Index b) {
    a = root(a);
    b = root(b);
    if (a == b) return false;
    if (a > b) std::swap(a, b);
    parent(b) = a;
    return true;
  }

 private:
  Index& parent(Index i) { return parent_[static_cast<size_t>(i)]; }

  std::vector<Index> parent_;
};

}  // namespace vug
