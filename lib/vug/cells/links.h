// SPDX-License-Identifier: Apache-2.0
// Adjacency of cells in compressed sparse rows.
#pragma once

#include <vug/base/parallel.h>

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace vug::cells {

/// Neighbours of cell i: to[begin[i]] .. to[begin[i + 1] - 1] in ascending order. A network's links
/// are mutual: each appears in both rows.
struct Links {
  std::vector<uint32_t> begin{0};  ///< Number of cells plus one.
  std::vector<uint32_t> to;

  size_t size() const { return begin.size() - 1; }
  uint32_t degree(uint32_t cell) const { return begin[cell + 1] - begin[cell]; }
  std::span<const uint32_t> of(uint32_t cell) const {
    return {to.data() + begin[cell], degree(cell)};
  }
  bool operator==(const Links&) const = default;
};

/// Builds `cells` rows: `collect(cell, add)` calls add(neighbour) in the order of the row. It is
/// called twice per cell, in parallel, and must behave identically both times.
template <class Collect>
Links make_links(size_t cells, const Collect& collect) {
  constexpr size_t kGrain = 4096;
  Links links;
  links.begin.assign(cells + 1, 0);
  parallel_for(
      cells,
      [&](size_t i) {
        uint32_t count = 0;
        collect(static_cast<uint32_t>(i), [&](uint32_t) { ++count; });
        links.begin[i + 1] = count;
      },
      kGrain);
  std::partial_sum(links.begin.begin(), links.begin.end(), links.begin.begin());
  links.to.resize(links.begin.back());
  parallel_for(
      cells,
      [&](size_t i) {
        uint32_t at = links.begin[i];
        collect(static_cast<uint32_t>(i), [&](uint32_t neighbour) { links.to[at++] = neighbour; });
      },
      kGrain);
  return links;
}

}  // namespace vug::cells
