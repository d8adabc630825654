// SPDX-License-Identifier: Apache-2.0
// Connected regions of the pixels of a view.
#pragma once

#include <vug/scout/view.h>

#include <utility>

namespace vug::scout {

struct Region {
  size_t pixels = 0;
  bool sky = false;     ///< Its first pixel sees the sky.
  bool cut = false;     ///< It touches the edge of the picture.
  uint32_t object = 0;  ///< That of its first pixel.
};

/// Divides a view into regions of pixels that are neighbours in a row or a column, in the order of
/// their first pixels. `joins(first, from, next)` decides whether `next` belongs to the region of
/// its neighbour `from`, whose first pixel is `first`.
template <class Joins>
std::vector<Region> connected_regions(const View& view, const Joins& joins) {
  std::vector<char> known(view.pixels.size(), 0);
  std::vector<Region> regions;
  std::vector<std::pair<int, int>> pending;
  for (int y0 = 0; y0 < view.height; ++y0)
    for (int x0 = 0; x0 < view.width; ++x0) {
      if (known[view.index(x0, y0)]) continue;
      const Seen& first = view.at(x0, y0);
      Region region{0, first.object == kSky, false, first.object};
      known[view.index(x0, y0)] = 1;
      pending.assign(1, {x0, y0});
      while (!pending.empty()) {
        const auto [x, y] = pending.back();
        pending.pop_back();
        ++region.pixels;
        for (const auto& [dx, dy] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
          const int u = x + dx, v = y + dy;
          if (u < 0 || v < 0 || u >= view.width || v >= view.height) {
            region.cut = true;
            continue;
          }
          if (known[view.index(u, v)] || !joins(first, view.at(x, y), view.at(u, v))) continue;
          known[view.index(u, v)] = 1;
          pending.emplace_back(u, v);
        }
      }
      regions.push_back(region);
    }
  return regions;
}

}  // namespace vug::scout
