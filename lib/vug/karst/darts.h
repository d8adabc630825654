// SPDX-License-Identifier: Apache-2.0
// Internal to karst: dart throwing, which accepts points that keep a distance from each other.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

namespace vug::karst {

class Darts {
 public:
  /// `distance` in metres, positive.
  explicit Darts(double distance) : distance_(distance) {}

  /// Whether no point that was added is nearer than the distance.
  bool is_free(const Vec3d& point) const {
    const Cell cell = cell_of(point);
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
  void add(const Vec3d& point) { cells_[cell_of(point)].push_back(point); }

 private:
  using Cell = std::array<int64_t, 3>;
  struct Hash {
    size_t operator()(const Cell& c) const {
      return static_cast<size_t>(c[0] * 73856093) ^ static_cast<size_t>(c[1] * 19349663) ^
             static_cast<size_t>(c[2] * 83492791);
    }
  };

  Cell cell_of(const Vec3d& p) const {
    return {static_cast<int64_t>(std::floor(p.x / distance_)),
            static_cast<int64_t>(std::floor(p.y / distance_)),
            static_cast<int64_t>(std::floor(p.z / distance_))};
  }

  double distance_;
  std::unordered_map<Cell, std::vector<Vec3d>, Hash> cells_;
};

}  // namespace vug::karst
