// SPDX-License-Identifier: Apache-2.0
#include <vug/base/parallel.h>
#include <vug/scan/inpaint.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {
namespace {

constexpr int kNone = INT32_MAX;

/// For each pixel the row of the nearest pixel with points in its column, within the reach.
std::vector<int> nearest_rows(const RangeImage& image, int reach) {
  std::vector<int> rows(image.pixel_count(), kNone);
  parallel_for(static_cast<size_t>(image.width), [&](size_t column) {
    const int x = static_cast<int>(column);
    int last = kNone;
    for (int y = 0; y < image.height; ++y) {
      if (image.count[image.index(x, y)] > 0) last = y;
      if (last != kNone && y - last <= reach) rows[image.index(x, y)] = last;
    }
    last = kNone;
    for (int y = image.height - 1; y >= 0; --y) {
      if (image.count[image.index(x, y)] > 0) last = y;
      int& row = rows[image.index(x, y)];
      if (last != kNone && last - y <= reach && (row == kNone || last - y < y - row)) row = last;
    }
  });
  return rows;
}

}  // namespace

void inpaint(RangeImage& image, double reach) {
  const int within = static_cast<int>(std::floor(reach));
  if (within < 1) return;
  const std::vector<int> rows = nearest_rows(image, within);
  const std::vector<float> depth = image.depth;
  parallel_for(static_cast<size_t>(image.height), [&](size_t row) {
    const int y = static_cast<int>(row);
    for (int x = 0; x < image.width; ++x) {
      if (image.count[image.index(x, y)] > 0) continue;
      double best = reach * reach;
      for (int from = std::max(0, x - within); from <= std::min(image.width - 1, x + within);
           ++from) {
        const int found = rows[image.index(from, y)];
        if (found == kNone) continue;
        const double dx = from - x, dy = found - y;
        const bool first = std::isnan(image.depth[image.index(x, y)]);
        if (dx * dx + dy * dy < best || (first && dx * dx + dy * dy <= best)) {
          best = dx * dx + dy * dy;
          image.depth[image.index(x, y)] = depth[image.index(from, found)];
        }
      }
    }
  });
}

}  // namespace vug::scan
