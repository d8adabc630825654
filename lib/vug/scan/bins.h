// SPDX-License-Identifier: Apache-2.0
// Sparse square bins for points in a plane.
#pragma once

#include <vug/base/vec.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace vug::scan {

/// Row, then column.
using BinKey = std::pair<int64_t, int64_t>;

inline BinKey bin_of(const Vec2d& p, double side) {
  // Limits far beyond any facade and well within the range of the integer type.
  const auto index = [&](double v) {
    return static_cast<int64_t>(std::floor(std::clamp(v / side, -1e15, 1e15)));
  };
  return {index(p.y), index(p.x)};
}

/// The occupied bins, sorted by key.
struct Bins {
  std::vector<BinKey> keys;
  std::vector<uint32_t> counts;
  std::vector<uint32_t> bin_of_point;  ///< One entry per point.

  /// The index of a bin, or -1.
  int64_t find(const BinKey& key) const {
    const auto found = std::lower_bound(keys.begin(), keys.end(), key);
    return found != keys.end() && *found == key ? found - keys.begin() : -1;
  }
};

inline Bins bin_points(const std::vector<Vec2d>& points, double side) {
  Bins out;
  std::vector<BinKey> all;
  all.reserve(points.size());
  for (const Vec2d& p : points) all.push_back(bin_of(p, side));
  out.keys = all;
  std::sort(out.keys.begin(), out.keys.end());
  out.keys.erase(std::unique(out.keys.begin(), out.keys.end()), out.keys.end());
  out.counts.assign(out.keys.size(), 0);
  out.bin_of_point.reserve(points.size());
  for (const BinKey& key : all) {
    out.bin_of_point.push_back(static_cast<uint32_t>(out.find(key)));
    ++out.counts[out.bin_of_point.back()];
  }
  return out;
}

}  // namespace vug::scan
