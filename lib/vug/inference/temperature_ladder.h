// Temperatures of chains that exchange their states.
#pragma once

#include <cstdint>
#include <vector>

namespace vug::inference {

class TemperatureLadder {
 public:
  /// From the coldest to the hottest by equal factors. Error(bad_input) for no chain, or
  /// temperatures that are not above 0 and rising.
  TemperatureLadder(int chains, double coldest, double hottest);

  double temperature(int i) const { return temperatures_[static_cast<size_t>(i)]; }
  /// Probability of exchanging the states, of these energies in bits, of chain i and the next.
  double acceptance(int i, double energy, double next_energy) const;

  void count(int i, double acceptance, bool swapped);
  /// Moves the temperatures between the ends towards equal acceptance, less and less from call to
  /// call; counts since the last call are used (Vousden et al. 2016, equations 10 to 13).
  void adapt();

  struct Swaps {
    int64_t tried = 0, taken = 0;
    double rate() const {
      return tried > 0 ? static_cast<double>(taken) / static_cast<double>(tried) : 0;
    }
  };
  /// Of each pair of neighbours since the beginning, or since `forget`.
  const std::vector<Swaps>& swaps() const { return swaps_; }
  void forget();

 private:
  std::vector<double> temperatures_;
  double hottest_ = 0;  ///< As it was at first.
  std::vector<Swaps> swaps_;
  std::vector<double> sums_;  ///< Acceptances since the last adapt,
  std::vector<int> terms_;    ///< and how many.
  int64_t adapted_ = 0;
};

}  // namespace vug::inference
