// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/link.h>
#include <vug/cells/surface_distance.h>
#include <vug/mesh/point_grid.h>

#include <algorithm>
#include <array>

namespace vug::cells {
namespace {

constexpr uint32_t kNoCell = ~0u;
constexpr uint32_t kMost = 8;

/// The nearest few candidates, sorted by distance.
class Nearest {
 public:
  explicit Nearest(uint32_t full) : full_(full) {}

  float limit(float reach2) const { return count_ < full_ ? reach2 : distance_[count_ - 1]; }
  void offer(float distance, uint32_t cell) {
    // Candidates arrive by runs, not by index: among equally near ones the lower index wins.
    const auto nearer_than = [&](uint32_t k) {
      return distance < distance_[k] || (distance == distance_[k] && cell < cell_[k]);
    };
    if (count_ == full_ && !nearer_than(count_ - 1)) return;
    uint32_t at = count_ < full_ ? count_++ : count_ - 1;
    for (; at > 0 && nearer_than(at - 1); --at)
      distance_[at] = distance_[at - 1], cell_[at] = cell_[at - 1];
    distance_[at] = distance, cell_[at] = cell;
  }
  /// Sorted by index, with kNoCell after the last.
  void write(uint32_t* out) {
    for (uint32_t i = 1; i < count_; ++i)
      for (uint32_t k = i; k > 0 && cell_[k - 1] > cell_[k]; --k) std::swap(cell_[k - 1], cell_[k]);
    for (uint32_t i = 0; i < full_; ++i) out[i] = i < count_ ? cell_[i] : kNoCell;
  }

 private:
  uint32_t full_;
  uint32_t count_ = 0;
  std::array<float, kMost> distance_;
  std::array<uint32_t, kMost> cell_;
};

/// For each cell, the `full` cells that it selects.
std::vector<uint32_t> select_nearest(const mesh::PointGrid& grid, const std::vector<Vec3f>& normal,
                                     double reach, uint32_t full) {
  const std::vector<Vec3f>& position = grid.points();
  const auto reach2 = static_cast<float>(reach * reach);
  std::vector<uint32_t> held(grid.size() * full);
  grid.for_each_cube([&](mesh::PointGrid::Run cube, const mesh::PointGrid::Runs& around) {
    for (uint32_t i = cube.begin; i < cube.end; ++i) {
      Nearest nearest(full);
      for (const mesh::PointGrid::Run& run : around)
        for (uint32_t j = run.begin; j < run.end; ++j) {
          const float limit = nearest.limit(reach2);
          if ((position[j] - position[i]).length2() > limit || j == i) continue;
          const float d = surface_distance2(position[i], normal[i], position[j], normal[j]);
          if (d <= limit) nearest.offer(d, j);
        }
      nearest.write(&held[size_t{i} * full]);
    }
  });
  return held;
}

/// Distributes the area among cells by the squared lengths of their links.
std::vector<float> areas(const Network& n, double total) {
  std::vector<float> area(n.size());
  const auto one = static_cast<float>(n.spacing * n.spacing);
  parallel_for(
      n.size(),
      [&](size_t i) {
        const auto cell = static_cast<uint32_t>(i);
        float sum = 0;
        for (const uint32_t to : n.links.of(cell))
          sum += (n.position[to] - n.position[i]).length2();
        area[i] = n.links.degree(cell) > 0 ? sum / static_cast<float>(n.links.degree(cell)) : one;
      },
      kCellGrain);
  const double sum =
      ordered_sum(area.size(), 0.0, [&](size_t i) { return static_cast<double>(area[i]); });
  if (sum > 0)
    for (float& a : area) a *= static_cast<float>(total / sum);
  return area;
}

}  // namespace

Network link(const std::vector<SurfacePoint>& places, const Surface& surface, double spacing,
             double reach, uint32_t full, Progress& progress) {
  progress.begin("linking cells", 3);
  // Slightly wider, to allow for rounding when points are sorted into cubes.
  const mesh::PointGrid grid(positions(places), reach * 1.001);
  progress.advance();
  progress.check();
  Network n;
  n.spacing = spacing, n.reach = reach, n.full = full;
  n.position = grid.points();
  n.normal.resize(places.size());
  n.object.resize(places.size());
  parallel_for(
      places.size(),
      [&](size_t i) {
        const SurfacePoint& place = places[grid.order()[i]];
        n.normal[i] = place.normal;
        n.object[i] = surface.triangles()[place.triangle].object;
      },
      kCellGrain);
  const std::vector<uint32_t> held = select_nearest(grid, n.normal, reach, full);
  progress.advance();
  progress.check();
  n.links = make_links(places.size(), [&](uint32_t i, const auto& add) {
    for (uint32_t k = 0; k < full && held[size_t{i} * full + k] != kNoCell; ++k) {
      const uint32_t to = held[size_t{i} * full + k];
      const uint32_t* row = &held[size_t{to} * full];
      if (std::find(row, row + full, i) != row + full) add(to);
    }
  });
  n.area = areas(n, surface.area());
  progress.end();
  return n;
}

}  // namespace vug::cells
