// SPDX-License-Identifier: Apache-2.0
// Internal to breakdown/: the blocks near a block, and the tops of all blocks as a height map.
#pragma once

#include <vug/passages/breakdown/pile.h>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace vug::passages {

/// Blocks by the square cell in plan that contains their centre.
class BoxGrid {
 public:
  /// `largest`: the diagonal of the largest block, metres.
  explicit BoxGrid(double largest) : cell_(largest) {}

  void add(const OrientedBox& block) {
    cells_[cell_of(block.centre)].emplace_back(block, count_++);
  }

  /// Calls visit(block, index) for all blocks that can overlap this one in plan; the index counts
  /// the blocks in the order in which they were added.
  template <class Visit>
  void for_each_near(const OrientedBox& block, const Visit& visit) const {
    const auto [x, z] = cell_of(block.centre);
    const Box3d box = block.bounds();
    for (int i = x - 1; i <= x + 1; ++i)
      for (int j = z - 1; j <= z + 1; ++j) {
        const auto found = cells_.find({i, j});
        if (found == cells_.end()) continue;
        for (const auto& [other, index] : found->second) {
          const Box3d its = other.bounds();
          if (its.min.x < box.max.x && its.max.x > box.min.x && its.min.z < box.max.z &&
              its.max.z > box.min.z)
            visit(other, index);
        }
      }
  }

 private:
  std::pair<int, int> cell_of(const Vec3d& p) const;

  double cell_;
  size_t count_ = 0;
  std::map<std::pair<int, int>, std::vector<std::pair<OrientedBox, size_t>>> cells_;
};

/// The height above the floor of the highest block in each column of a grid over the cone.
class TopMap {
 public:
  TopMap(const Pile& pile, double margin);

  void add(const OrientedBox& block);
  /// The volume below the tops, cubic metres.
  double volume() const { return sum_ * cell_ * cell_; }
  /// The mean height of the cone above the tops in a square about a point.
  double mean_lack(const Vec3d& p, double half) const;

 private:
  Vec3d column(int i, int j) const;
  std::pair<int, int> index(double x, double z) const;
  double& top(int i, int j) { return tops_[static_cast<size_t>(j * count_ + i)]; }

  const Pile cone_;
  double cell_ = 1;
  double start_x_ = 0, start_z_ = 0;
  int count_ = 0;
  std::vector<double> tops_;
  double sum_ = 0;
};

}  // namespace vug::passages
