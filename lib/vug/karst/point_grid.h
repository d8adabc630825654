// SPDX-License-Identifier: Apache-2.0
// A grid of points for queries of neighbours.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <cstdint>
#include <vector>

namespace vug::karst {

/// Points in the cells of a grid over their bounding box. Points with the same coordinates are
/// allowed; all must be finite.
class PointGrid {
 public:
  /// `per_cell`: the mean number of points in an occupied cell for which the cells are sized.
  PointGrid(const std::vector<Vec3d>& points, double per_cell);

  /// The indices of the `count` points nearest to the point with an index, without itself, by
  /// distance and then index. Fewer if the set has fewer.
  std::vector<int> nearest(int index, int count) const;

 private:
  std::array<int, 3> cell_of(const Vec3d& point) const;
  size_t cell_index(const std::array<int, 3>& cell) const;

  const std::vector<Vec3d>& points_;
  Box3d box_;
  double side_ = 1;
  std::array<int, 3> cells_{1, 1, 1};
  std::vector<int> first_;    ///< Start of each cell in `indices_`, and the end of the last one.
  std::vector<int> indices_;  ///< Points by cell, in each by index.
};

}  // namespace vug::karst
