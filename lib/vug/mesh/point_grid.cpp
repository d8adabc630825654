// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel_sort.h>
#include <vug/mesh/point_grid.h>

#include <fmt/format.h>

#include <cmath>
#include <tuple>

namespace vug::mesh {
namespace {

struct Entry {
  uint64_t key = 0;
  Vec3f point;
  uint32_t index = 0;

  bool operator<(const Entry& other) const {
    if (key != other.key) return key < other.key;
    return std::tie(point.x, point.y, point.z, index) <
           std::tie(other.point.x, other.point.y, other.point.z, other.index);
  }
};

constexpr size_t kGrain = 4096;

/// Axes from the longest side to the shortest.
std::array<int, 3> by_length(const Vec3d& size) {
  std::array<int, 3> axes = {0, 1, 2};
  std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] > size[b]; });
  return axes;
}

}  // namespace

PointGrid::PointGrid(const std::vector<Vec3f>& points, double edge)
    : points_(points.size()), order_(points.size()) {
  const Box3f box = ordered_reduce(
      points.size(), Box3f(), [&](size_t i) { return Box3f(points[i]); },
      [](Box3f a, const Box3f& b) { return a.extendBy(b), a; });
  const Vec3d low = points.empty() ? Vec3d(0) : Vec3d(box.min);
  const Vec3d size = points.empty() ? Vec3d(0) : Vec3d(box.max) - low;
  const std::array<int, 3> axes = by_length(size);
  // An empty cube on either side, so that no neighbour's key belongs to another row.
  const double most = std::floor(size[axes[0]] / edge) + 3;
  if (!(most <= 1 << 20))
    throw Error(ErrorCode::too_large,
                fmt::format("{:.4g} m contain too many steps of {:.3g} m", size[axes[0]], edge));
  row_ = static_cast<uint64_t>(size[axes[2]] / edge) + 3;
  slab_ = row_ * (static_cast<uint64_t>(size[axes[1]] / edge) + 3);

  std::vector<Entry> entries(points.size());
  const double scale = 1 / edge;
  parallel_for(
      points.size(),
      [&](size_t i) {
        const auto step = [&](int axis) {
          return static_cast<uint64_t>((static_cast<double>(points[i][axis]) - low[axis]) * scale) +
                 1;
        };
        entries[i] = {step(axes[0]) * slab_ + step(axes[1]) * row_ + step(axes[2]), points[i],
                      static_cast<uint32_t>(i)};
      },
      kGrain);
  parallel_sort(entries.begin(), entries.end());
  parallel_for(
      entries.size(),
      [&](size_t i) {
        points_[i] = entries[i].point;
        order_[i] = entries[i].index;
      },
      kGrain);
  for (uint32_t i = 0; i < entries.size(); ++i)
    if (i == 0 || entries[i].key != entries[i - 1].key) cubes_.push_back({entries[i].key, i});
  cubes_.push_back({UINT64_MAX, static_cast<uint32_t>(entries.size())});
}

}  // namespace vug::mesh
