// SPDX-License-Identifier: Apache-2.0
// Rectangles of pixels.
#pragma once

#include <algorithm>
#include <cstddef>

namespace vug::render {

/// Pixels x0 <= x < x1, y0 <= y < y1, counted from the picture's top left corner.
struct Region {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int width() const { return x1 - x0; }
  int height() const { return y1 - y0; }
  bool empty() const { return x1 <= x0 || y1 <= y0; }
  size_t pixels() const {
    return empty() ? 0 : static_cast<size_t>(width()) * static_cast<size_t>(height());
  }
  size_t index(int x, int y) const {
    return static_cast<size_t>(y - y0) * static_cast<size_t>(width()) + static_cast<size_t>(x - x0);
  }
  Region overlap(const Region& other) const {
    return {std::max(x0, other.x0), std::max(y0, other.y0), std::min(x1, other.x1),
            std::min(y1, other.y1)};
  }
  /// Tile number `index` of a cover with square tiles, row by row from the top left.
  Region tile(size_t index, int side) const {
    const size_t across = static_cast<size_t>((width() + side - 1) / side);
    const int x = x0 + static_cast<int>(index % across) * side;
    const int y = y0 + static_cast<int>(index / across) * side;
    return {x, y, std::min(x + side, x1), std::min(y + side, y1)};
  }
  size_t tiles(int side) const {
    return empty() ? 0
                   : static_cast<size_t>((width() + side - 1) / side) *
                         static_cast<size_t>((height() + side - 1) / side);
  }

  bool operator==(const Region&) const = default;
};

}  // namespace vug::render
