// SPDX-License-Identifier: Apache-2.0
// Points sorted into cubic cells, so that neighbours in space are close in memory. All points
// within one cell edge of a point lie in 27 cells, which are nine contiguous runs of the sorted
// order.
#pragma once

#include <vug/base/parallel.h>
#include <vug/base/vec.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace vug::mesh {

class PointGrid {
 public:
  /// The sorted points begin .. end - 1.
  struct Run {
    uint32_t begin = 0;
    uint32_t end = 0;
  };
  using Runs = std::array<Run, 9>;

  /// Sorts by cell, along the longest axis of the bounding box first, and within a cell by
  /// coordinates. The result does not depend on the input order, except among equal points. `edge`
  /// is in metres, above 0. Throws Error(too_large) if an axis has more than 2^20 cells.
  PointGrid(const std::vector<Vec3f>& points, double edge);

  size_t size() const { return points_.size(); }
  /// The points in sorted order.
  const std::vector<Vec3f>& points() const { return points_; }
  /// For each sorted point, its index in the input.
  const std::vector<uint32_t>& order() const { return order_; }

  /// Calls body(cube, around) in parallel for each cell that contains points: the run of its own
  /// points, and the runs of the surrounding cells including itself.
  template <class Body>
  void for_each_cube(const Body& body) const;

 private:
  struct Cube {
    uint64_t key = 0;
    uint32_t begin = 0;
  };
  static constexpr size_t kChunk = 512;

  size_t first_at(uint64_t key) const {
    const auto below = [](const Cube& cube, uint64_t k) { return cube.key < k; };
    return static_cast<size_t>(std::lower_bound(cubes_.begin(), cubes_.end(), key, below) -
                               cubes_.begin());
  }

  std::vector<Vec3f> points_;
  std::vector<uint32_t> order_;
  std::vector<Cube> cubes_;  ///< Sorted by key, with one sentinel at the end.
  uint64_t row_ = 0;         ///< Difference of keys between neighbours along the second axis.
  uint64_t slab_ = 0;        ///< Difference of keys between neighbours along the first axis.
};

template <class Body>
void PointGrid::for_each_cube(const Body& body) const {
  const size_t cubes = cubes_.size() - 1;
  parallel_for((cubes + kChunk - 1) / kChunk, [&](size_t chunk) {
    const size_t first = chunk * kChunk, last = std::min(cubes, first + kChunk);
    // The keys of the nine rows grow with the key of the middle cell, so one cursor per row
    // suffices.
    std::array<uint64_t, 9> offset;
    std::array<size_t, 9> cursor;
    for (size_t r = 0; r < 9; ++r) {
      offset[r] = (r / 3) * slab_ + (r % 3) * row_ - slab_ - row_ - 1;  // modulo 2^64
      cursor[r] = first_at(cubes_[first].key + offset[r]);
    }
    Runs around;
    for (size_t c = first; c < last; ++c) {
      for (size_t r = 0; r < 9; ++r) {
        const uint64_t low = cubes_[c].key + offset[r];
        size_t& at = cursor[r];
        while (cubes_[at].key < low) ++at;
        size_t behind = at;
        while (cubes_[behind].key <= low + 2) ++behind;
        around[r] = {cubes_[at].begin, cubes_[behind].begin};
      }
      body(Run{cubes_[c].begin, cubes_[c + 1].begin}, around);
    }
  });
}

}  // namespace vug::mesh
