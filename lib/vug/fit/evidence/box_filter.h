// SPDX-License-Identifier: Apache-2.0
// Box filters over image planes, computed with summed area tables (cite crow1984).
#pragma once

#include <cstddef>
#include <vector>

namespace vug::fit {

/// One value per pixel, row by row from the top.
using Plane = std::vector<float>;

/// Box means of a plane, clipped to the picture. Sizes are half widths in pixels, not counting the
/// centre pixel.
class BoxFilter {
 public:
  BoxFilter(int width, int height, const Plane& plane);

  Plane mean(int half_x, int half_y) const;
  Plane mean(int half) const { return mean(half, half); }
  /// Means over full rows (`half` rows to either side), over full columns, and over the whole
  /// picture.
  Plane rows(int half) const { return mean(width_, half); }
  Plane columns(int half) const { return mean(half, height_); }
  Plane whole() const { return mean(width_, height_); }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * (static_cast<size_t>(width_) + 1) + static_cast<size_t>(x);
  }

  int width_, height_;
  std::vector<double> table_;  ///< Summed area table, exclusive of the entry's own row and column.
};

/// Difference and square, value by value.
Plane difference(const Plane& a, const Plane& b);
Plane squared(const Plane& plane);
/// Absolute central difference along x or y, one-sided at the border.
Plane central_differences(int width, int height, const Plane& plane, bool along_x);

/// Scale unit of box sizes: 1/160 of the height, at least one pixel. Box sizes are multiples of it,
/// so that pictures of one facade at two resolutions have comparable features.
inline int box_unit(int height) { return height / 160 > 1 ? height / 160 : 1; }

}  // namespace vug::fit
