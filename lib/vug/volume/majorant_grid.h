// SPDX-License-Identifier: Apache-2.0
// Bounds of a density in bricks of one size, for traversal along rays.
#pragma once

#include <vug/base/vec.h>

#include <algorithm>
#include <cstdint>
#include <vector>

namespace vug::volume {

/// Space from index coordinates 0 to `reach`, divided into cubes of `size` voxels; the last ones
/// may extend beyond it.
class MajorantGrid {
 public:
  MajorantGrid(int size, const Vec3i& reach);
  /// Merges the bricks into bricks of twice the size.
  MajorantGrid doubled() const;

  int size() const { return size_; }  ///< Voxels along the edge of a brick.
  const Vec3i& reach() const { return reach_; }
  const Vec3i& count() const { return count_; }  ///< Bricks along each axis.

  /// Bounds of all interpolated values in a brick, and their approximate mean.
  struct Range {
    float min = 0, mean = 0, max = 0;
  };
  /// Bricks are stored in rows of x, then planes, with a border of empty bricks on all sides.
  size_t index(const Vec3i& brick) const {
    return static_cast<size_t>(brick.x + 1) + row_ * static_cast<size_t>(brick.y + 1) +
           plane_ * static_cast<size_t>(brick.z + 1);
  }
  size_t row() const { return row_; }
  size_t plane() const { return plane_; }
  const Range& range(size_t index) const { return ranges_[index]; }
  void set(const Vec3i& brick, const Range& range) { ranges_[index(brick)] = range; }
  /// Calls visit(brick) for each brick except the border.
  template <class Visit>
  void each(const Visit& visit) const {
    for (int z = 0; z < count_.z; ++z)
      for (int y = 0; y < count_.y; ++y)
        for (int x = 0; x < count_.x; ++x) visit(Vec3i(x, y, z));
  }
  /// Voxels of a brick that lie within `reach`.
  double voxels(const Vec3i& brick) const;
  /// Integral of the maxima, in voxels.
  double bound() const;
  uint64_t bytes() const { return ranges_.size() * sizeof(Range); }

 private:
  int size_;
  Vec3i reach_, count_;
  size_t row_, plane_;
  std::vector<Range> ranges_;
};

}  // namespace vug::volume
