// SPDX-License-Identifier: Apache-2.0
#include <vug/karst/point_grid.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

constexpr double kMostCells = 4e6;

}  // namespace

PointGrid::PointGrid(const std::vector<Vec3d>& points, double per_cell) : points_(points) {
  for (const Vec3d& point : points) box_.extendBy(point);
  if (points.empty()) box_ = Box3d(Vec3d(0.0));
  const Vec3d size = box_.size();
  // Flat sets have few layers of cells, so their sides follow from the area.
  const double wanted = std::max(1.0, static_cast<double>(points.size()) / per_cell);
  const double largest = std::max({size.x, size.y, size.z, 1e-6});
  const auto cells_along = [&](double length) { return std::floor(length / side_) + 1; };
  side_ = largest;
  const auto cell_total = [&] {
    return cells_along(size.x) * cells_along(size.y) * cells_along(size.z);
  };
  while (cell_total() < wanted && cell_total() < kMostCells) side_ /= 1.25;
  for (int axis = 0; axis < 3; ++axis)
    cells_[static_cast<size_t>(axis)] = static_cast<int>(cells_along(size[axis]));
  const size_t total = static_cast<size_t>(cells_[0]) * static_cast<size_t>(cells_[1]) *
                       static_cast<size_t>(cells_[2]);
  first_.assign(total + 1, 0);
  for (const Vec3d& point : points) ++first_[cell_index(cell_of(point)) + 1];
  for (size_t i = 1; i <= total; ++i) first_[i] += first_[i - 1];
  std::vector<int> next(first_.begin(), first_.end() - 1);
  indices_.resize(points.size());
  for (size_t i = 0; i < points.size(); ++i)
    indices_[static_cast<size_t>(next[cell_index(cell_of(points[i]))]++)] = static_cast<int>(i);
}

std::array<int, 3> PointGrid::cell_of(const Vec3d& point) const {
  std::array<int, 3> cell{};
  for (int axis = 0; axis < 3; ++axis)
    cell[static_cast<size_t>(axis)] =
        std::clamp(static_cast<int>((point[axis] - box_.min[axis]) / side_), 0,
                   cells_[static_cast<size_t>(axis)] - 1);
  return cell;
}

size_t PointGrid::cell_index(const std::array<int, 3>& cell) const {
  return (static_cast<size_t>(cell[2]) * static_cast<size_t>(cells_[1]) +
          static_cast<size_t>(cell[1])) *
             static_cast<size_t>(cells_[0]) +
         static_cast<size_t>(cell[0]);
}

std::vector<int> PointGrid::nearest(int index, int count) const {
  const Vec3d& point = points_[static_cast<size_t>(index)];
  const std::array<int, 3> middle = cell_of(point);
  const int most = std::max({cells_[0], cells_[1], cells_[2]});
  std::vector<std::pair<double, int>> found;
  const auto wanted = static_cast<size_t>(count);
  for (int ring = 0; ring <= most; ++ring) {
    // All points within (ring - 1) sides of the point have been visited; is that enough?
    if (found.size() >= wanted && ring > 1) {
      std::nth_element(found.begin(), found.begin() + (count - 1), found.end());
      const double reached = (ring - 1) * side_;
      if (found[wanted - 1].first <= reached * reached) break;
    }
    for (int z = std::max(0, middle[2] - ring); z <= std::min(cells_[2] - 1, middle[2] + ring); ++z)
      for (int y = std::max(0, middle[1] - ring); y <= std::min(cells_[1] - 1, middle[1] + ring);
           ++y)
        for (int x = std::max(0, middle[0] - ring); x <= std::min(cells_[0] - 1, middle[0] + ring);
             ++x) {
          if (std::max({std::abs(x - middle[0]), std::abs(y - middle[1]),
                        std::abs(z - middle[2])}) != ring)
            continue;
          const size_t cell = cell_index({x, y, z});
          for (int i = first_[cell]; i < first_[cell + 1]; ++i) {
            const int other = indices_[static_cast<size_t>(i)];
            if (other != index)
              found.emplace_back((points_[static_cast<size_t>(other)] - point).length2(), other);
          }
        }
  }
  std::sort(found.begin(), found.end());
  if (found.size() > wanted) found.resize(wanted);
  std::vector<int> result;
  for (const auto& entry : found) result.push_back(entry.second);
  return result;
}

}  // namespace vug::karst
