// SPDX-License-Identifier: Apache-2.0
// Distances between straight legs, and a grid that finds the near ones.
#pragma once

#include <vug/base/vec.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace vug::karst {

struct SegmentPiece {
  Vec3d from{0.0};
  Vec3d to{0.0};
};

/// The square of the least distance between two segments in square metres; segments without a
/// length are points.
double distance2(const SegmentPiece& a, const SegmentPiece& b);

/// Whether the angle between two vectors is less than the acute one with this sine.
inline bool nearly_parallel(const Vec3d& a, const Vec3d& b, double sine) {
  return a.dot(b) > 0 && a.cross(b).length2() < sine * sine * a.length2() * b.length2();
}

/// Segments with numbers in the cells of a grid, each in all cells within `reach` metres of it.
class SegmentGrid {
 public:
  /// `side` of the cells and `reach` in metres, the side positive.
  SegmentGrid(double side, double reach) : side_(side), reach_(reach) {}

  void add(int number, const SegmentPiece& segment) {
    for_each_cell(segment, reach_, [&](const Cell& cell) {
      std::vector<int>& numbers = cells_[cell];
      if (numbers.empty() || numbers.back() != number) numbers.push_back(number);
    });
  }

  /// Calls `visit(number)` for each segment within the reach of another one, and for some others,
  /// until it returns true; returns whether it did. A number may be visited several times.
  template <class Visit>
  bool any_near(const SegmentPiece& segment, const Visit& visit) const {
    bool found = false;
    for_each_cell(segment, 0, [&](const Cell& cell) {
      if (found) return;
      const auto numbers = cells_.find(cell);
      if (numbers == cells_.end()) return;
      found = std::any_of(numbers->second.begin(), numbers->second.end(), visit);
    });
    return found;
  }

 private:
  using Cell = std::array<int64_t, 3>;
  struct Hash {
    size_t operator()(const Cell& c) const {
      return static_cast<size_t>(c[0] * 73856093) ^ static_cast<size_t>(c[1] * 19349663) ^
             static_cast<size_t>(c[2] * 83492791);
    }
  };

  /// The cells of boxes around pieces of the segment that are at most a side long.
  template <class Visit>
  void for_each_cell(const SegmentPiece& segment, double margin, const Visit& visit) const {
    const Vec3d way = segment.to - segment.from;
    const auto pieces = static_cast<int64_t>(std::ceil(way.length() / side_)) + 1;
    for (int64_t i = 0; i < pieces; ++i) {
      const Vec3d start = segment.from + way * (static_cast<double>(i) / double(pieces));
      const Vec3d end = segment.from + way * (static_cast<double>(i + 1) / double(pieces));
      Cell low{}, high{};
      for (int axis = 0; axis < 3; ++axis) {
        const auto k = static_cast<size_t>(axis);
        low[k] = cell_at(std::min(start[axis], end[axis]) - margin);
        high[k] = cell_at(std::max(start[axis], end[axis]) + margin);
      }
      for (int64_t x = low[0]; x <= high[0]; ++x)
        for (int64_t y = low[1]; y <= high[1]; ++y)
          for (int64_t z = low[2]; z <= high[2]; ++z) visit(Cell{x, y, z});
    }
  }
  int64_t cell_at(double coordinate) const {
    return static_cast<int64_t>(std::floor(coordinate / side_));
  }

  double side_;
  double reach_;
  std::unordered_map<Cell, std::vector<int>, Hash> cells_;
};

}  // namespace vug::karst
