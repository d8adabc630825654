// SPDX-License-Identifier: Apache-2.0
// Distances between straight legs, and a grid that finds the near ones.
#pragma once

#include <vug/base/cell.h>

#include <algorithm>
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
  /// The cells of boxes around pieces of the segment that are at most a side long.
  template <class Visit>
  void for_each_cell(const SegmentPiece& segment, double margin, const Visit& visit) const {
    const Vec3d way = segment.to - segment.from;
    const auto pieces = static_cast<int64_t>(std::ceil(way.length() / side_)) + 1;
    for (int64_t i = 0; i < pieces; ++i) {
      const Vec3d start = segment.from + way * (static_cast<double>(i) / double(pieces));
      const Vec3d end = segment.from + way * (static_cast<double>(i + 1) / double(pieces));
      Vec3d low, high;
      for (int axis = 0; axis < 3; ++axis) {
        low[axis] = std::min(start[axis], end[axis]) - margin;
        high[axis] = std::max(start[axis], end[axis]) + margin;
      }
      vug::for_each_cell(cell_at(low, side_), cell_at(high, side_), visit);
    }
  }

  double side_;
  double reach_;
  CellMap<std::vector<int>> cells_;
};

}  // namespace vug::karst
