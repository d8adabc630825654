// Where along a line something is likely to be: weights of whole places, drawn from in any window.
#pragma once

#include <cstddef>
#include <vector>

namespace vug::inference {

/// Windows are [low, high) with 0 <= low < high <= size; a place's probability is its weight over
/// the window's sum. Drawing takes the logarithm of the window's length in steps.
class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  /// Error(bad_input) for weights that are not finite and above 0: every place can be drawn, so
  /// that whatever a chain leaves it can return to.
  explicit DiscreteDistribution(const std::vector<double>& weights);
  /// A mixture: `share` of the weights, made to sum to 1, and the rest even.
  static DiscreteDistribution mixture(std::vector<double> weights, double share);

  int size() const { return static_cast<int>(sums_.size()) - 1; }
  /// The place at which the weights before it reach the share u in [0, 1) of the window's sum.
  int find(int low, int high, double u) const;
  /// Natural logarithm of its probability; -infinity outside of the window.
  double ln_probability(int low, int high, int place) const;

 private:
  double sum(int low, int high) const {
    return sums_[static_cast<size_t>(high)] - sums_[static_cast<size_t>(low)];
  }
  std::vector<double> sums_ = {0};  ///< Of all weights before a place; one more than places.
};

}  // namespace vug::inference
