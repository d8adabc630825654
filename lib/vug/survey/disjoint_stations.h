// SPDX-License-Identifier: Apache-2.0
// Sets of stations that are joined by legs or equates.
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace vug::survey {

/// Union-find over 0..n-1; the root of a set is its smallest member.
class DisjointStations {
 public:
  explicit DisjointStations(size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0);
  }

  int root(int i) {
    while (at(i) != i) i = at(i) = at(at(i));
    return i;
  }

  /// Returns true if the two were in different sets.
  bool join(int a, int b) {
    a = root(a);
    b = root(b);
    at(std::max(a, b)) = std::min(a, b);
    return a != b;
  }

 private:
  int& at(int i) { return parent_[static_cast<size_t>(i)]; }

  std::vector<int> parent_;
};

}  // namespace vug::survey
