// SPDX-License-Identifier: Apache-2.0
// Likely positions of edges in the picture, used as proposal distributions.
#pragma once

#include <vug/fit/evidence/evidence.h>
#include <vug/inference/discrete_distribution.h>

namespace vug::fit {

/// Distributions over the positions between pixels: 0 is the left or top border, the picture's
/// width or height the other one. Hints change how fast chains converge, not the distribution they
/// converge to.
struct EdgeHints {
  inference::DiscreteDistribution left, right;  ///< Edges of windows along x.
  inference::DiscreteDistribution top, bottom;  ///< Edges of windows along y.
  /// The line between ground floor and upper part, along y.
  inference::DiscreteDistribution floor;

  /// All positions are equally likely.
  static EdgeHints uniform(int width, int height);
  /// Positions at which the clusters of whole columns and rows change.
  static EdgeHints from_clusters(const Evidence& evidence);
  /// Positions at which whole columns and rows start or stop looking like windows; `evidence` holds
  /// code lengths per RegionType.
  static EdgeHints from_supervised(const Evidence& evidence);
};

}  // namespace vug::fit
