// SPDX-License-Identifier: Apache-2.0
#include <vug/base/median.h>
#include <vug/base/parallel.h>
#include <vug/scan/cell_depths.h>

#include <algorithm>
#include <cmath>

namespace vug::scan {

CellDepths cell_depths(const RangeImage& range, double cell, const std::vector<uint8_t>& only) {
  CellDepths out;
  const double largest = std::max(range.width, range.height);
  out.side = std::max(1, static_cast<int>(std::lround(std::min(cell / range.pixel, largest))));
  out.across = (range.width + out.side - 1) / out.side;
  out.down = (range.height + out.side - 1) / out.side;
  out.depths.assign(static_cast<size_t>(out.across) * static_cast<size_t>(out.down), std::nan(""));
  parallel_for(out.depths.size(), [&](size_t i) {
    const int x0 = static_cast<int>(i % static_cast<size_t>(out.across)) * out.side;
    const int y0 = static_cast<int>(i / static_cast<size_t>(out.across)) * out.side;
    std::vector<float> depths;
    for (int y = y0; y < std::min(y0 + out.side, range.height); ++y)
      for (int x = x0; x < std::min(x0 + out.side, range.width); ++x) {
        const size_t pixel = range.index(x, y);
        if (!std::isnan(range.depth[pixel]) && (only.empty() || only[pixel]))
          depths.push_back(range.depth[pixel]);
      }
    if (!depths.empty()) out.depths[i] = median(std::move(depths));
  });
  return out;
}

}  // namespace vug::scan
