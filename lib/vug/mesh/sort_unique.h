// SPDX-License-Identifier: Apache-2.0
// Lists of indices as sets.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vug::mesh {

/// Sorts the indices ascending and removes duplicates.
inline void sort_unique(std::vector<uint32_t>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

}  // namespace vug::mesh
