// SPDX-License-Identifier: Apache-2.0
// Weighted linear regression around each pixel: a plane through the values of its neighbours, over
// their positions and features.
#pragma once

#include <cstddef>
#include <vector>

namespace vug::image {

/// The normal equations of one regression for each of several pixels, with three channels.
class LocalRegression {
 public:
  static constexpr size_t kMostUnknowns = 16;

  /// `unknowns`: 1 and the number of regressors, at most kMostUnknowns.
  LocalRegression(size_t pixels, size_t unknowns);

  /// Adds a neighbour. `at`: 1, then its regressors minus those of the pixel. `values`: its
  /// channels.
  void add(size_t pixel, float weight, const float* at, const float* values);
  /// The values of the plane at the pixel itself, between a quarter of the weighted mean of the
  /// neighbours and four times that mean, because a plane through noise around an unusual normal
  /// would leave a black or a bright dot; 0 for a negative mean. A small ridge keeps slopes of
  /// regressors that do not vary at 0. The sum of the weights must be positive.
  void solve(size_t pixel, float* values) const;

 private:
  size_t unknowns_, moments_per_pixel_;
  std::vector<float> moments_;  ///< Lower triangles, row by row.
  std::vector<float> targets_;  ///< Three channels of each unknown.
};

}  // namespace vug::image
