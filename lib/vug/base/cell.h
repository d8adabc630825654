// SPDX-License-Identifier: Apache-2.0
// The cells of unbounded grids, and tables by cell.
#pragma once

#include <vug/base/vec.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace vug {

using Cell = std::array<int64_t, 3>;

/// The cell of a point in a grid with cells of that side, in metres.
inline Cell cell_at(const Vec3d& p, double side) {
  return {static_cast<int64_t>(std::floor(p.x / side)),
          static_cast<int64_t>(std::floor(p.y / side)),
          static_cast<int64_t>(std::floor(p.z / side))};
}

struct CellHash {
  size_t operator()(const Cell& c) const {
    return static_cast<size_t>(c[0] * 73856093) ^ static_cast<size_t>(c[1] * 19349663) ^
           static_cast<size_t>(c[2] * 83492791);
  }
};

template <class T>
using CellMap = std::unordered_map<Cell, T, CellHash>;

/// Calls `visit(cell)` for all cells of a box of cells.
template <class Visit>
void for_each_cell(const Cell& low, const Cell& high, const Visit& visit) {
  for (int64_t x = low[0]; x <= high[0]; ++x)
    for (int64_t y = low[1]; y <= high[1]; ++y)
      for (int64_t z = low[2]; z <= high[2]; ++z) visit(Cell{x, y, z});
}

}  // namespace vug
