// SPDX-License-Identifier: Apache-2.0
// Internal to karst: dart throwing, which accepts points that keep a distance from each other.
#pragma once

#include <vug/base/cell.h>

#include <vector>

namespace vug::karst {

class Darts {
 public:
  /// `distance` in metres, positive.
  explicit Darts(double distance) : distance_(distance) {}

  /// Whether no point that was added is nearer than the distance.
  bool is_free(const Vec3d& point) const {
    const Cell cell = cell_at(point, distance_);
    for (int64_t x = cell[0] - 1; x <= cell[0] + 1; ++x)
      for (int64_t y = cell[1] - 1; y <= cell[1] + 1; ++y)
        for (int64_t z = cell[2] - 1; z <= cell[2] + 1; ++z) {
          const auto found = cells_.find({x, y, z});
          if (found == cells_.end()) continue;
          for (const Vec3d& other : found->second)
            if ((other - point).length2() < distance_ * distance_) return false;
        }
    return true;
  }
  void add(const Vec3d& point) { cells_[cell_at(point, distance_)].push_back(point); }

 private:
  double distance_;
  CellMap<std::vector<Vec3d>> cells_;
};

}  // namespace vug::karst
