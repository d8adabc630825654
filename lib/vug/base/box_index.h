// SPDX-License-Identifier: Apache-2.0
// Boxes of very different sizes, found by place while more of them are added.
#pragma once

#include <vug/base/cell.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace vug {

/// Numbers with boxes. Grids whose cells double in side contain the boxes that fit into a cell,
/// each in the cell of its middle.
class BoxIndex {
 public:
  /// Empty boxes are found nowhere, and infinite ones everywhere.
  void add(int number, const Box3d& box) {
    if (box.isEmpty()) return;
    const Vec3d size = box.size();
    int level = 0;
    std::frexp(std::max({size.x, size.y, size.z}), &level);
    level = std::max(level, kLeastLevel);
    const double side = std::ldexp(1.0, level);
    if (is_finite(box) && level <= kMostLevel && box.center().length() < kFarthestCell * side)
      grids_[level][cell_at(box.center(), side)].push_back({number, box});
    else
      everywhere_.push_back(number);
  }

  /// Calls `visit(number)` for each box that meets another one, which must be finite, until it
  /// returns true; returns whether it did.
  template <class Visit>
  bool any_meeting(const Box3d& box, const Visit& visit) const {
    if (std::any_of(everywhere_.begin(), everywhere_.end(), visit)) return true;
    for (const auto& [level, grid] : grids_) {
      const double side = std::ldexp(1.0, level);
      const Vec3d margin(0.5 * side);
      bool found = false;
      const auto look = [&](const std::vector<Entry>& entries) {
        found = found || std::any_of(entries.begin(), entries.end(), [&](const Entry& entry) {
                  return entry.box.intersects(box) && visit(entry.number);
                });
      };
      const Vec3d cells = (box.size() + 2.0 * margin) / side + Vec3d(1.0);
      if (cells.x * cells.y * cells.z > static_cast<double>(grid.size())) {
        for (const auto& [cell, entries] : grid) look(entries);
      } else {
        for_each_cell(cell_at(box.min - margin, side), cell_at(box.max + margin, side),
                      [&, &grid = grid](const Cell& cell) {
                        if (const auto at = grid.find(cell); at != grid.end()) look(at->second);
                      });
      }
      if (found) return true;
    }
    return false;
  }

 private:
  struct Entry {
    int number = 0;
    Box3d box;
  };
  static constexpr int kLeastLevel = -20;  ///< Cells of a micrometre.
  static constexpr int kMostLevel = 60;
  static constexpr double kFarthestCell = 1e15;  ///< So that numbers of cells are integers.

  std::map<int, CellMap<std::vector<Entry>>> grids_;  ///< By the exponent of the side, metres.
  std::vector<int> everywhere_;
};

}  // namespace vug
