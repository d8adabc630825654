// SPDX-License-Identifier: Apache-2.0
// Pictures of one scene with different seeds, whose spread gives the error of their mean.
#pragma once

#include "scenes.h"

#include <cmath>

namespace vug::render {

/// The green channel of pictures with the layer `variance`.
class Runs {
 public:
  void add(const image::Image& picture) {
    const double mean = mean_of(picture, "G").value;
    ++count_;
    sum_ += mean;
    squares_ += mean * mean;
    variance_ += mean_of(picture, "variance.G").value;
  }
  double mean() const { return sum_ / count_; }
  /// The mean of the variances that the pictures contain.
  double variance() const { return variance_ / count_; }
  double squared_error() const { return (squares_ / count_ - mean() * mean()) / (count_ - 1); }

 private:
  double count_ = 0, sum_ = 0, squares_ = 0, variance_ = 0;
};

/// The standard error of the difference of both means.
inline double error_of_difference(const Runs& a, const Runs& b) {
  return std::sqrt(a.squared_error() + b.squared_error());
}

}  // namespace vug::render
