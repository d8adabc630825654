// SPDX-License-Identifier: Apache-2.0
// Parallel greedy sample elimination: removes points until no two are too close, with the same
// result as visiting the points one by one in order of rank.
#pragma once

#include <vug/mesh/point_grid.h>

#include <atomic>

namespace vug::mesh {

/// Returns, in the grid's sorted order, 1 for each point that stays and 0 for the others. A point
/// is removed if `close(i, j)` for a remaining point j of smaller rank. Points of rank 0 always
/// stay; other equal ranks are ordered by position in the grid. `close` must be symmetric, return
/// false for points at least one grid edge apart, and be thread-safe. Ranks should be random,
/// otherwise many rounds are needed.
template <class Close>
std::vector<uint8_t> eliminate_samples(const PointGrid& grid, const std::vector<uint64_t>& rank,
                                       const Close& close) {
  constexpr uint8_t kRemoved = 0, kKept = 1, kUndecided = 2;
  std::vector<uint8_t> status(grid.size());
  for (size_t i = 0; i < status.size(); ++i) status[i] = rank[i] == 0 ? kKept : kUndecided;
  const auto before = [&](uint32_t i, uint32_t j) {
    return rank[i] != rank[j] ? rank[i] < rank[j] : i < j;
  };
  // A decision depends only on final decisions, so the order in which threads see them is
  // irrelevant.
  const auto status_of = [&](uint32_t i) {
    return std::atomic_ref(status[i]).load(std::memory_order_relaxed);
  };
  const auto decide = [&](uint32_t i, uint8_t as) {
    std::atomic_ref(status[i]).store(as, std::memory_order_relaxed);
  };
  std::vector<std::vector<uint32_t>> rivals(grid.size());  // the points that can eliminate a point
  grid.for_each_cube([&](PointGrid::Run cube, const PointGrid::Runs& around) {
    for (uint32_t i = cube.begin; i < cube.end; ++i) {
      if (rank[i] == 0) continue;
      bool removed = false;
      for (const PointGrid::Run& run : around)
        for (uint32_t j = run.begin; j < run.end && !removed; ++j) {
          if (j == i || !before(j, i) || !close(i, j)) continue;
          removed = rank[j] == 0;
          if (!removed) rivals[i].push_back(j);
        }
      if (removed || rivals[i].empty()) decide(i, removed ? kRemoved : kKept);
    }
  });
  std::vector<uint32_t> pending;
  for (uint32_t i = 0; i < status.size(); ++i)
    if (status[i] == kUndecided) pending.push_back(i);
  while (!pending.empty()) {
    parallel_for(
        pending.size(),
        [&](size_t k) {
          bool undecided = false, removed = false;
          for (const uint32_t j : rivals[pending[k]]) {
            const uint8_t other = status_of(j);
            undecided |= other == kUndecided;
            removed |= other == kKept;
          }
          if (removed || !undecided) decide(pending[k], removed ? kRemoved : kKept);
        },
        1024);
    pending.erase(std::remove_if(pending.begin(), pending.end(),
                                 [&](uint32_t i) { return status[i] != kUndecided; }),
                  pending.end());
  }
  return status;
}

}  // namespace vug::mesh
