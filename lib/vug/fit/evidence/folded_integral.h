// SPDX-License-Identifier: Apache-2.0
// How much better windows explain the pixels of an area than wall, over areas with several
// instances in the picture.
#pragma once

#include <vug/fit/evidence/evidence.h>
#include <vug/fit/model/model.h>

namespace vug::fit {

/// Bits per lane that a pixel saves as part of a window instead of the wall.
using Gains = std::array<double, kMaxLanes>;

/// Gains for supervised evidence.
Gains supervised_gains();
/// Gains for clusters, from the distribution of window and wall pixels of a tree over the clusters.
Gains gains_from_regions(const Sums& windows, const Sums& wall, int lanes);
/// Gains from the windows of the grid below node i against the rest of its area.
Gains gains_from_grid(const Model& model, const Evidence& evidence, const TreeState& state, int i);
double gain_of(const Gains& gains, const Sums& sums);

/// The gain of each pixel, row by row from the top.
struct GainMap {
  GainMap(const Evidence& evidence, const Gains& gains);

  int width = 0, height = 0;
  std::vector<double> gains;
};

/// Summed area table of gains for an area whose instances are folded on top of each other.
class FoldedIntegral {
 public:
  FoldedIntegral(const GainMap& map, const TreeState& state, const Area& area);
  /// A copy in which the rectangle (in the area) gains nothing because another element occupies it.
  FoldedIntegral without(const Rect& rect) const;

  int width() const { return width_; }
  int height() const { return height_; }
  /// Gain of the area's pixels x0 <= x < x1, y0 <= y < y1, summed over all instances.
  double sum(int x0, int y0, int x1, int y1) const {
    return at(x1, y1) - at(x0, y1) - at(x1, y0) + at(x0, y0);
  }
  /// Upper estimate of the gain if each square of a few pixels could be chosen independently.
  /// Instances that do not match each other reduce it.
  double potential() const;

 private:
  double at(int x, int y) const {
    return table_[static_cast<size_t>(y) * static_cast<size_t>(width_ + 1) +
                  static_cast<size_t>(x)];
  }
  int width_, height_;
  std::vector<double> table_;
};

}  // namespace vug::fit
