// SPDX-License-Identifier: Apache-2.0
// Discrete distribution over integer positions that can be sampled in any window.
#pragma once

#include <cstddef>
#include <vector>

namespace vug::inference {

/// Windows are [low, high) with 0 <= low < high <= size; the probability of an index is its weight
/// divided by the window's sum. Sampling takes O(log(window length)) steps.
class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// Throws Error(bad_input) unless all weights are finite and positive: every index must have a
  /// positive probability, so that a chain can return to every state that it leaves.
  explicit DiscreteDistribution(const std::vector<double>& weights);
  /// A mixture of the normalized weights, with the proportion `share`, and a uniform distribution.
  static DiscreteDistribution mixture(std::vector<double> weights, double share);

  int size() const { return static_cast<int>(sums_.size()) - 1; }
  /// The inverse of the window's cumulative distribution at u in [0, 1).
  int find(int low, int high, double u) const;
  /// Natural logarithm of the probability of the index `place`; -infinity outside of the window.
  double ln_probability(int low, int high, int place) const;

 private:
  double sum(int low, int high) const {
    return sums_[static_cast<size_t>(high)] - sums_[static_cast<size_t>(low)];
  }
  std::vector<double> sums_ = {0};  ///< Prefix sums of the weights; one more than weights.
};

}  // namespace vug::inference
