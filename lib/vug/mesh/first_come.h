// Thins a set of points until none that are left are too close: the choice that someone makes who
// takes them one by one by rising rank, made by all threads at once.
#pragma once

#include <vug/mesh/point_grid.h>

#include <atomic>

namespace vug::mesh {

/// 1 for each point that stays, 0 for the others: one stays unless `close(i, j)` for a point j of
/// smaller rank that stays. Points of rank 0 all stay; other ranks that are equal go by number.
/// `close` is symmetric, says no for points `radius` or more apart and may be called by several
/// threads. Ranks should be as good as random, or many rounds are needed.
template <class Close>
std::vector<uint8_t> first_come(const std::vector<Vec3f>& points, const std::vector<uint64_t>& rank,
                                double radius, const Close& close) {
  constexpr uint8_t kGoes = 0, kStays = 1, kOpen = 2;
  const PointGrid grid(points, radius);
  std::vector<uint8_t> fate(points.size());
  for (size_t i = 0; i < points.size(); ++i) fate[i] = rank[i] == 0 ? kStays : kOpen;
  const auto before = [&](uint32_t i, uint32_t j) {
    return rank[i] != rank[j] ? rank[i] < rank[j] : i < j;
  };
  // A decision depends only on final ones, so it does not matter when a thread sees another's.
  const auto decide = [&](uint32_t i, const PointGrid::Runs& around) {
    bool waits = false;
    for (const PointGrid::Run& run : around)
      for (uint32_t slot = run.begin; slot < run.end; ++slot) {
        const uint32_t j = grid.order()[slot];
        const uint8_t other = std::atomic_ref(fate[j]).load(std::memory_order_relaxed);
        if (other == kGoes || j == i || !before(j, i) || !close(i, j)) continue;
        if (other == kStays) return kGoes;
        waits = true;
      }
    return waits ? kOpen : kStays;
  };
  std::atomic<bool> open{true};
  while (open.exchange(false))
    grid.sweep([&](PointGrid::Run cube, const PointGrid::Runs& around) {
      for (uint32_t slot = cube.begin; slot < cube.end; ++slot) {
        const uint32_t i = grid.order()[slot];
        const std::atomic_ref own(fate[i]);
        if (own.load(std::memory_order_relaxed) != kOpen) continue;
        const uint8_t now = decide(i, around);
        if (now == kOpen)
          open.store(true, std::memory_order_relaxed);
        else
          own.store(now, std::memory_order_relaxed);
      }
    });
  return fate;
}

}  // namespace vug::mesh
