// Square cells of a plane that hold points, however far apart these are.
#pragma once

#include <vug/base/vec.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace vug::scan {

/// Row, then column.
using CellKey = std::pair<int64_t, int64_t>;

inline CellKey cell_of(const Vec2d& p, double side) {
  // Far beyond any facade, and far within what an integer holds.
  const auto index = [&](double v) {
    return static_cast<int64_t>(std::floor(std::clamp(v / side, -1e15, 1e15)));
  };
  return {index(p.y), index(p.x)};
}

/// The cells that hold points, in the order of their keys.
struct Cells {
  std::vector<CellKey> keys;
  std::vector<uint32_t> counts;
  std::vector<uint32_t> cell_of_point;  ///< One for each point.

  /// The index of a cell, or -1.
  int64_t find(const CellKey& key) const {
    const auto found = std::lower_bound(keys.begin(), keys.end(), key);
    return found != keys.end() && *found == key ? found - keys.begin() : -1;
  }
};

inline Cells cells_of(const std::vector<Vec2d>& points, double side) {
  Cells out;
  std::vector<CellKey> all;
  all.reserve(points.size());
  for (const Vec2d& p : points) all.push_back(cell_of(p, side));
  out.keys = all;
  std::sort(out.keys.begin(), out.keys.end());
  out.keys.erase(std::unique(out.keys.begin(), out.keys.end()), out.keys.end());
  out.counts.assign(out.keys.size(), 0);
  out.cell_of_point.reserve(points.size());
  for (const CellKey& key : all) {
    out.cell_of_point.push_back(static_cast<uint32_t>(out.find(key)));
    ++out.counts[out.cell_of_point.back()];
  }
  return out;
}

}  // namespace vug::scan
