// SPDX-License-Identifier: Apache-2.0
#include <vug/scout/nnls.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace vug::scout {

NonNegativeFit fit_non_negative(const std::vector<std::vector<double>>& columns,
                                const std::vector<double>& target) {
  constexpr int kMostSweeps = 2000;
  constexpr double kConverged = 1e-12;  // relative change of the weights
  NonNegativeFit fit;
  fit.weights.assign(columns.size(), 0);
  std::vector<double> rest = target;
  for (int sweep = 0; sweep < kMostSweeps; ++sweep) {
    double change = 0, size = 0;
    for (size_t j = 0; j < columns.size(); ++j) {
      double product = 0, square = 0;
      for (size_t i = 0; i < target.size(); ++i) {
        product += columns[j][i] * rest[i];
        square += columns[j][i] * columns[j][i];
      }
      if (!(square > 0)) continue;
      const double next = std::max(0.0, fit.weights[j] + product / square);
      const double by = next - fit.weights[j];
      for (size_t i = 0; i < target.size(); ++i) rest[i] -= by * columns[j][i];
      fit.weights[j] = next;
      change = std::max(change, std::fabs(by));
      size = std::max(size, next);
    }
    if (change <= kConverged * size) break;
  }
  for (const double each : rest) fit.residual += each * each;
  return fit;
}

}  // namespace vug::scout
