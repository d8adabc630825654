// SPDX-License-Identifier: Apache-2.0
#include <vug/image/local_regression.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace vug::image {
namespace {

constexpr double kRidge = 0.01;  // of the sum of the weights
/// The largest ratio of a result to the weighted mean of the neighbours, and of the mean to a
/// result.
constexpr double kMostContrast = 4;

}  // namespace

LocalRegression::LocalRegression(size_t pixels, size_t unknowns)
    : unknowns_(std::min(unknowns, kMostUnknowns)),
      moments_per_pixel_(unknowns_ * (unknowns_ + 1) / 2),
      moments_(pixels * moments_per_pixel_),
      targets_(pixels * unknowns_ * 3) {}

void LocalRegression::add(size_t pixel, float weight, const float* at, const float* values) {
  float* moment = &moments_[pixel * moments_per_pixel_];
  float* target = &targets_[pixel * unknowns_ * 3];
  for (size_t i = 0; i < unknowns_; ++i) {
    const float weighted = weight * at[i];
    for (size_t j = 0; j <= i; ++j) *moment++ += weighted * at[j];
    for (size_t c = 0; c < 3; ++c) *target++ += weighted * values[c];
  }
}

void LocalRegression::solve(size_t pixel, float* values) const {
  using Row = std::array<double, kMostUnknowns>;
  std::array<Row, kMostUnknowns> factor;  // of Cholesky
  const float* moment = &moments_[pixel * moments_per_pixel_];
  const double weight = static_cast<double>(*moment);
  const double ridge = kRidge * weight;
  for (size_t i = 0; i < unknowns_; ++i)
    for (size_t j = 0; j <= i; ++j) {
      double sum = static_cast<double>(*moment++) + (i == j && i > 0 ? ridge : 0);
      for (size_t k = 0; k < j; ++k) sum -= factor[i][k] * factor[j][k];
      factor[i][j] = i == j ? std::sqrt(std::max(sum, 1e-30)) : sum / factor[j][j];
    }
  const float* target = &targets_[pixel * unknowns_ * 3];
  for (size_t c = 0; c < 3; ++c) {
    Row solution;
    for (size_t i = 0; i < unknowns_; ++i) {
      double sum = static_cast<double>(target[3 * i + c]);
      for (size_t k = 0; k < i; ++k) sum -= factor[i][k] * solution[k];
      solution[i] = sum / factor[i][i];
    }
    for (size_t i = unknowns_; i-- > 0;) {
      double sum = solution[i];
      for (size_t k = i + 1; k < unknowns_; ++k) sum -= factor[k][i] * solution[k];
      solution[i] = sum / factor[i][i];
    }
    const double mean = std::max(0.0, static_cast<double>(target[c]) / weight);
    values[c] =
        static_cast<float>(std::clamp(solution[0], mean / kMostContrast, mean * kMostContrast));
  }
}

}  // namespace vug::image
