// SPDX-License-Identifier: Apache-2.0
#include <vug/field/heightmap.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::field {
namespace {

/// Four neighbouring samples along one axis with their weights in the value and in the slope.
struct Stencil {
  std::array<int, 4> index;
  std::array<double, 4> weight, slope;
};

Stencil stencil(double x, double length, int count, Sampling sampling) {
  const double per_metre = (count - 1) / length;
  const double place = std::clamp(x * per_metre, 0.0, count - 1.0);
  const int cell = std::min(static_cast<int>(place), count - 2);
  const double t = place - cell, inside = x < 0 || x > length ? 0 : per_metre;
  Stencil s;
  for (int i = 0; i < 4; ++i)
    s.index[static_cast<size_t>(i)] = std::clamp(cell - 1 + i, 0, count - 1);
  if (sampling == Sampling::bilinear) {
    s.weight = {0, 1 - t, t, 0};
    s.slope = {0, -inside, inside, 0};
  } else {
    s.weight = {0.5 * t * (-1 + t * (2 - t)), 1 + 0.5 * t * t * (-5 + 3 * t),
                0.5 * t * (1 + t * (4 - 3 * t)), 0.5 * t * t * (t - 1)};
    s.slope = {inside * 0.5 * (-1 + t * (4 - 3 * t)), inside * 0.5 * t * (-10 + 9 * t),
               inside * 0.5 * (1 + t * (8 - 9 * t)), inside * 0.5 * t * (3 * t - 2)};
  }
  return s;
}

/// The maximum change per cell along a row of four samples. A cubic's slope lies among those of its
/// Bezier polygon; the magnitudes of the Catmull-Rom weights add up to at most 5/4.
double steepness(double a, double b, double c, double d, Sampling sampling) {
  if (sampling == Sampling::bilinear) return std::fabs(c - b);
  const double middle = 3 * (c - b) - 0.5 * (c - a + d - b);
  return std::max({0.5 * std::fabs(c - a), std::fabs(middle), 0.5 * std::fabs(d - b)});
}

}  // namespace

Heightmap::Heightmap(int columns, int rows, std::vector<float> heights, double width, double depth,
                     Sampling sampling)
    : columns_(columns), rows_(rows), width_(width), depth_(depth), sampling_(sampling) {
  const auto height = [&](int column, int row) {
    const int i = std::clamp(column, 0, columns - 1), j = std::clamp(row, 0, rows - 1);
    return static_cast<double>(
        heights[static_cast<size_t>(j) * static_cast<size_t>(columns) + static_cast<size_t>(i)]);
  };
  double along_u = 0, along_v = 0;
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      along_u = std::max(along_u, steepness(height(i - 1, j), height(i, j), height(i + 1, j),
                                            height(i + 2, j), sampling));
      along_v = std::max(along_v, steepness(height(i, j - 1), height(i, j), height(i, j + 1),
                                            height(i, j + 2), sampling));
    }
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  range_ = {static_cast<double>(*low), static_cast<double>(*high)};
  const double spread = sampling == Sampling::bicubic ? 1.25 : 1;
  const double more = 0.5 * range_.width() * (spread * spread - 1);
  range_ = {range_.lo - more, range_.hi + more};
  const double u = spread * along_u * (columns - 1) / width;
  const double v = spread * along_v * (rows - 1) / depth;
  max_slope_ = std::sqrt(u * u + v * v);
  heights_ = std::make_shared<const std::vector<float>>(std::move(heights));
}

Heightmap::Height Heightmap::at(double u, double v) const {
  const Stencil x = stencil(u, width_, columns_, sampling_);
  const Stencil y = stencil(v, depth_, rows_, sampling_);
  Height out;
  for (size_t j = 0; j < 4; ++j) {
    const float* row =
        heights_->data() + static_cast<size_t>(y.index[j]) * static_cast<size_t>(columns_);
    double value = 0, slope = 0;
    for (size_t i = 0; i < 4; ++i) {
      const double height = static_cast<double>(row[x.index[i]]);
      value += x.weight[i] * height;
      slope += x.slope[i] * height;
    }
    out.value += y.weight[j] * value;
    out.slope_u += y.weight[j] * slope;
    out.slope_v += y.slope[j] * value;
  }
  return out;
}

}  // namespace vug::field
