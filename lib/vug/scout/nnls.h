// SPDX-License-Identifier: Apache-2.0
// Least squares with non-negative unknowns, for a handful of unknowns.
#pragma once

#include <vector>

namespace vug::scout {

struct NonNegativeFit {
  std::vector<double> weights;  ///< At least 0 each.
  double residual = 0;          ///< Sum of the squared errors.
};

/// Minimizes |sum of w_j columns[j] - target|^2 over w >= 0 by cyclic coordinate descent, which
/// converges for this convex problem (Franc, Hlavac and Navara 2005, cite franc2005nnls). Columns
/// of zeros get the weight 0.
NonNegativeFit fit_non_negative(const std::vector<std::vector<double>>& columns,
                                const std::vector<double>& target);

}  // namespace vug::scout
