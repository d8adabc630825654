// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/inference/bits.h>
#include <vug/inference/temperature_ladder.h>

#include <algorithm>
#include <cmath>

namespace vug::inference {

TemperatureLadder::TemperatureLadder(int chains, double coldest, double hottest) {
  if (chains < 1 || !(coldest > 0) || !std::isfinite(hottest) || (chains > 1 && hottest <= coldest))
    throw Error(ErrorCode::bad_input, "the temperatures of chains must be positive and increasing");
  for (int i = 0; i < chains; ++i)
    temperatures_.push_back(
        i == 0 ? coldest
               : coldest * maths::pow(hottest / coldest, static_cast<double>(i) / (chains - 1)));
  hottest_ = temperatures_.back();
  forget();
  sums_.assign(swaps_.size(), 0);
  terms_.assign(swaps_.size(), 0);
}

void TemperatureLadder::forget() { swaps_.assign(temperatures_.size() - 1, {}); }

double TemperatureLadder::acceptance(int i, double energy, double next_energy) const {
  const double colder = 1 / temperature(i) - 1 / temperature(i + 1);
  return std::min(1.0, maths::exp(colder * (energy - next_energy) * kLn2));
}

void TemperatureLadder::count(int i, double acceptance, bool swapped) {
  const auto at = static_cast<size_t>(i);
  ++swaps_[at].tried;
  if (swapped) ++swaps_[at].taken;
  sums_[at] += acceptance;
  ++terms_[at];
}

void TemperatureLadder::adapt() {
  constexpr double kLag = 200;  // number of calls after which the step has halved
  const double rate = 0.3 * kLag / (kLag + static_cast<double>(adapted_++));
  const size_t pairs = swaps_.size();
  std::vector<double> gaps(pairs), mean(pairs);
  for (size_t i = 0; i < pairs; ++i) {
    gaps[i] = temperatures_[i + 1] - temperatures_[i];
    mean[i] = terms_[i] > 0 ? sums_[i] / terms_[i] : 0.5;
  }
  // The logarithm of a gap grows with the difference between its acceptance and that of the next
  // gap.
  for (size_t i = 0; i + 1 < pairs; ++i) {
    gaps[i] *= maths::exp(rate * (mean[i] - mean[i + 1]));
    temperatures_[i + 1] = temperatures_[i] + gaps[i];
  }
  // The hottest temperature moves until the last pair swaps as often as the others. It is bounded,
  // because equal hot states would let it grow without limit.
  if (pairs > 0)
    temperatures_[pairs] =
        std::min(4 * hottest_, temperatures_[pairs - 1] +
                                   gaps[pairs - 1] * maths::exp(rate * (mean[pairs - 1] - 0.35)));
  std::fill(sums_.begin(), sums_.end(), 0);
  std::fill(terms_.begin(), terms_.end(), 0);
}

}  // namespace vug::inference
