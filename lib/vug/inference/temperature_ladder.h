// SPDX-License-Identifier: Apache-2.0
// Temperature ladder for parallel tempering.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::inference {

class TemperatureLadder {
 public:
  /// Temperatures from the coldest to the hottest in a geometric progression. Throws
  /// Error(bad_input) if there are no chains or the temperatures are not positive and increasing.
  TemperatureLadder(int chains, double coldest, double hottest);

  double temperature(int i) const { return temperatures_[static_cast<size_t>(i)]; }
  /// Probability of swapping the states of chain i and the next, which have these energies in bits.
  double acceptance(int i, double energy, double next_energy) const;

  void count(int i, double acceptance, bool swapped);
  /// Moves the inner temperatures towards equal acceptance, with a step that decreases from call to
  /// call. Uses the counts since the last call (Vousden et al. 2016, equations 10 to 13).
  void adapt();

  struct Swaps {
    int64_t tried = 0, taken = 0;
    double rate() const {
      return tried > 0 ? static_cast<double>(taken) / static_cast<double>(tried) : 0;
    }
  };
  /// Swaps of each pair of neighbours since the beginning or the last `forget`.
  const std::vector<Swaps>& swaps() const { return swaps_; }
  void forget();

 private:
  std::vector<double> temperatures_;
  double hottest_ = 0;  ///< The initial hottest temperature.
  std::vector<Swaps> swaps_;
  std::vector<double> sums_;  ///< Sums of acceptances since the last `adapt`,
  std::vector<int> terms_;    ///< and their numbers.
  int64_t adapted_ = 0;
};

}  // namespace vug::inference
