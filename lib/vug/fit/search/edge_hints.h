// Where the picture says that edges may be, so that proposals need not try every place.
#pragma once

#include <vug/fit/evidence/evidence.h>
#include <vug/inference/discrete_distribution.h>

namespace vug::fit {

/// Over places between pixels: 0 is the picture's left or upper border, its width or height the
/// other one. Chains reach the same distribution with any hints, but not as soon.
struct EdgeHints {
  inference::DiscreteDistribution left, right;  ///< Of windows, places along x.
  inference::DiscreteDistribution top, bottom;  ///< Of windows, places along y.
  inference::DiscreteDistribution floor;  ///< Between the ground floor and the part above, along y.

  /// Every place is as likely as any other.
  static EdgeHints uniform(int width, int height);
  /// Where whole columns and rows of clusters change.
  static EdgeHints from_clusters(const Evidence& evidence);
  /// Where whole columns and rows begin, or cease, to look like windows rather than wall; `looks`
  /// are code lengths under each Look.
  static EdgeHints from_supervised(const Evidence& evidence);
};

}  // namespace vug::fit
