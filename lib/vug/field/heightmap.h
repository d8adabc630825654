// SPDX-License-Identifier: Apache-2.0
// Heights over a rectangle, interpolated from the samples of an image.
#pragma once

#include <vug/base/digester.h>
#include <vug/base/interval.h>
#include <vug/base/vec.h>

#include <memory>
#include <vector>

namespace vug::field {

enum class Sampling {
  bilinear,  ///< Continuous; creases along the rows and columns of samples.
  bicubic,   ///< Catmull-Rom spline: smooth, interpolates the samples, overshoots by up to 28 %.
};

/// Row 0 lies at v = 0; the first and last samples lie on the edges of the rectangle. Heights are
/// constant beyond the edges. Immutable; copies share the samples.
class Heightmap {
 public:
  struct Height {
    double value = 0;
    double slope_u = 0, slope_v = 0;
  };

  /// At least 2 x 2 heights, row by row; the rectangle is `width` by `depth` in size.
  Heightmap(int columns, int rows, std::vector<float> heights, double width, double depth,
            Sampling sampling);

  /// u in 0..width, v in 0..depth.
  Height at(double u, double v) const;
  /// Bounds of all heights.
  Interval range() const { return range_; }
  /// The maximum slope.
  double max_slope() const { return max_slope_; }

  void add_to(Digester& digester) const {
    digester(columns_, rows_, width_, depth_, sampling_, heights_);
  }

 private:
  int columns_, rows_;
  double width_, depth_;
  Sampling sampling_;
  std::shared_ptr<const std::vector<float>> heights_;
  Interval range_;
  double max_slope_ = 0;
};

}  // namespace vug::field
