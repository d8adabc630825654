// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/likelihood.h>
#include <vug/fit/search/edge_hints.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace vug::fit {
namespace {

using inference::DiscreteDistribution;
using Weights = std::vector<double>;

/// Pixels compared on each side of a position.
constexpr int kReach = 2;
/// Share of proposals that follow the picture.
constexpr double kHintWeight = 0.85;

/// Weights of the positions along an axis: the positive part of change(before, behind) for the sums
/// of the strips on both sides, each extending over the other axis.
Weights changes(const Evidence& evidence, bool along_x, int reach,
                const std::function<double(const Sums&, const Sums&)>& change) {
  const int size = along_x ? evidence.width() : evidence.height();
  const auto strip = [&](int begin, int end) {
    return along_x ? evidence.sums(begin, 0, end, evidence.height())
                   : evidence.sums(0, begin, evidence.width(), end);
  };
  Weights out(static_cast<size_t>(size) + 1, 0);
  for (int place = reach; place + reach <= size; ++place)
    out[static_cast<size_t>(place)] =
        std::max(0.0, change(strip(place - reach, place), strip(place, place + reach)));
  return out;
}

double difference(const Sums& sums, RegionType a, RegionType b) {
  return static_cast<double>(sums.lane[static_cast<size_t>(a)]) -
         static_cast<double>(sums.lane[static_cast<size_t>(b)]);
}

}  // namespace

EdgeHints EdgeHints::uniform(int width, int height) {
  const DiscreteDistribution x(Weights(static_cast<size_t>(width) + 1, 1));
  const DiscreteDistribution y(Weights(static_cast<size_t>(height) + 1, 1));
  return {x, x, y, y, y};
}

EdgeHints EdgeHints::from_clusters(const Evidence& evidence) {
  const auto change = [&](const Sums& before, const Sums& behind) {
    double sum = 0;
    for (size_t i = 0; i < before.lane.size(); ++i)
      sum += std::fabs(static_cast<double>(before.lane[i]) - static_cast<double>(behind.lane[i]));
    return sum;
  };
  const DiscreteDistribution x =
      DiscreteDistribution::mixture(changes(evidence, true, kReach, change), kHintWeight);
  const DiscreteDistribution y =
      DiscreteDistribution::mixture(changes(evidence, false, kReach, change), kHintWeight);
  const DiscreteDistribution floor =
      DiscreteDistribution::mixture(changes(evidence, false, 8 * kReach, change), kHintWeight);
  return {x, x, y, y, floor};
}

EdgeHints EdgeHints::from_supervised(const Evidence& evidence) {
  // Bits that a pixel saves as part of a window.
  const auto gain = [](const Sums& sums) {
    return difference(sums, RegionType::wall, RegionType::window);
  };
  const auto begins = [&](const Sums& before, const Sums& behind) {
    return gain(behind) - gain(before);
  };
  const auto ends = [&](const Sums& before, const Sums& behind) {
    return gain(before) - gain(behind);
  };
  const auto shops = [](const Sums& before, const Sums& behind) {
    return difference(behind, RegionType::wall, RegionType::shop) -
           difference(before, RegionType::wall, RegionType::shop);
  };
  const auto profile = [&](bool along_x, int reach, const auto& change) {
    return DiscreteDistribution::mixture(changes(evidence, along_x, reach, change), kHintWeight);
  };
  return {profile(true, kReach, begins), profile(true, kReach, ends),
          profile(false, kReach, begins), profile(false, kReach, ends),
          profile(false, 8 * kReach, shops)};
}

}  // namespace vug::fit
