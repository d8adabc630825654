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
  constexpr uint8_t kGoes = 0, kStays = 1, kOpen = 2;
  std::vector<uint8_t> fate(grid.size());
  for (size_t i = 0; i < fate.size(); ++i) fate[i] = rank[i] == 0 ? kStays : kOpen;
  const auto before = [&](uint32_t i, uint32_t j) {
    return rank[i] != rank[j] ? rank[i] < rank[j] : i < j;
  };
  // A decision depends only on final decisions, so the order in which threads see them is
  // irrelevant.
  const auto fate_of = [&](uint32_t i) {
    return std::atomic_ref(fate[i]).load(std::memory_order_relaxed);
  };
  const auto decide = [&](uint32_t i, uint8_t as) {
    std::atomic_ref(fate[i]).store(as, std::memory_order_relaxed);
  };
  std::vector<std::vector<uint32_t>> rivals(grid.size());  // the points that can eliminate a point
  grid.for_each_cube([&](PointGrid::Run cube, const PointGrid::Runs& around) {
    for (uint32_t i = cube.begin; i < cube.end; ++i) {
      if (rank[i] == 0) continue;
      bool goes = false;
      for (const PointGrid::Run& run : around)
        for (uint32_t j = run.begin; j < run.end && !goes; ++j) {
          if (j == i || !before(j, i) || !close(i, j)) continue;
          goes = rank[j] == 0;
          if (!goes) rivals[i].push_back(j);
        }
      if (goes || rivals[i].empty()) decide(i, goes ? kGoes : kStays);
    }
  });
  std::vector<uint32_t> open;
  for (uint32_t i = 0; i < fate.size(); ++i)
    if (fate[i] == kOpen) open.push_back(i);
  while (!open.empty()) {
    parallel_for(
        open.size(),
        [&](size_t k) {
          bool waits = false, goes = false;
          for (const uint32_t j : rivals[open[k]]) {
            const uint8_t other = fate_of(j);
            waits |= other == kOpen;
            goes |= other == kStays;
          }
          if (goes || !waits) decide(open[k], goes ? kGoes : kStays);
        },
        1024);
    open.erase(
        std::remove_if(open.begin(), open.end(), [&](uint32_t i) { return fate[i] != kOpen; }),
        open.end());
  }
  return fate;
}

}  // namespace vug::mesh
