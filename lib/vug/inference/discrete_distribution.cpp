// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/inference/discrete_distribution.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace vug::inference {

DiscreteDistribution::DiscreteDistribution(const std::vector<double>& weights) {
  sums_.reserve(weights.size() + 1);
  for (const double weight : weights) {
    if (!(weight > 0) || !std::isfinite(weight))
      throw Error(ErrorCode::bad_input, "the weights of a distribution must be finite and above 0");
    sums_.push_back(sums_.back() + weight);
  }
}

DiscreteDistribution DiscreteDistribution::mixture(std::vector<double> weights, double share) {
  const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
  const double scale = sum > 0 ? share / sum : 0;
  const double even = (sum > 0 ? 1 - share : 1) / static_cast<double>(weights.size());
  for (double& weight : weights) weight = weight * scale + even;
  return DiscreteDistribution(weights);
}

int DiscreteDistribution::find(int low, int high, double u) const {
  const double aim = sums_[static_cast<size_t>(low)] + u * sum(low, high);
  const auto first = sums_.begin() + low + 1, last = sums_.begin() + high;
  return static_cast<int>(std::upper_bound(first, last, aim) - first) + low;
}

double DiscreteDistribution::ln_probability(int low, int high, int place) const {
  if (place < low || place >= high) return -std::numeric_limits<double>::infinity();
  return maths::log(sum(place, place + 1) / sum(low, high));
}

}  // namespace vug::inference
