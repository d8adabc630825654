// SPDX-License-Identifier: Apache-2.0
// Parallel tempering (cite geyer1991): chains at several temperatures swap their states, so hot
// chains carry cold ones over energy barriers. The temperatures can adapt, with diminishing steps,
// until all neighbours swap equally often (cite vousden2016).
#pragma once

#include <vug/base/parallel.h>
#include <vug/base/progress.h>
#include <vug/inference/chain.h>
#include <vug/inference/temperature_ladder.h>

#include <algorithm>
#include <optional>

namespace vug::inference {

struct TemperingOptions {
  int chains = 8;
  double hottest = 64;  ///< Initial end of the temperature ladder, which starts at `coldest`.
  double coldest = 1;
  int64_t per_round = 500;  ///< Steps of each chain between two rounds of swaps.
};

/// Deterministic for any number of threads: each chain has its own random stream, and swaps are
/// drawn in order from another one.
template <class S>
class Tempering {
 public:
  using Options = TemperingOptions;

  /// `energy_for()` makes the energy function of one chain, which is not called concurrently. The
  /// coldest chain begins with the first of the starts, the next chain with the second, and so on
  /// in turn: a better mode that a hotter chain starts in moves down the ladder.
  Tempering(const Moves<S>& moves, const std::function<typename Chain<S>::Energy()>& energy_for,
            const std::vector<S>& starts, RandomKey key, Options options = {})
      : options_(options),
        ladder_(options.chains, options.coldest, options.hottest),
        swaps_(key.at("swap")) {
    for (int i = 0; i < options.chains; ++i)
      chains_.emplace_back(moves, energy_for(), starts.at(static_cast<size_t>(i) % starts.size()),
                           key.at("chain").at(static_cast<uint64_t>(i)),
                           typename Chain<S>::Options{ladder_.temperature(i), true});
    const auto best = std::min_element(
        chains_.begin(), chains_.end(),
        [](const Chain<S>& a, const Chain<S>& b) { return a.energy() < b.energy(); });
    best_ = best->state();
    best_energy_ = best->energy();
  }

  /// Multiplies all temperatures by a factor, as in annealing; swaps use the scaled temperatures.
  void set_scale(double scale) {
    scale_ = scale;
    for (size_t i = 0; i < chains_.size(); ++i)
      chains_[i].set_temperature(scale_ * ladder_.temperature(static_cast<int>(i)));
  }

  /// Runs rounds of steps and swaps. `adapt` moves all temperatures except the coldest; `visit`
  /// receives the coldest chain's state after each round. Stops after a complete round if
  /// cancelled.
  void run(int64_t rounds, bool adapt, Progress& progress = Progress::none(),
           const std::function<void(const S&, double energy)>& visit = {}) {
    for (int64_t round = 0; round < rounds && !progress.cancelled(); ++round) {
      parallel_for(chains_.size(), [&](size_t i) { steps(i); });
      for (size_t i = 0; i < chains_.size(); ++i) keep_best(i);
      exchange(adapt);
      if (visit) visit(chains_[0].state(), chains_[0].energy());
      progress.advance();
    }
  }

  /// The state with the lowest energy that any chain has visited.
  const S& best() const { return best_; }
  double best_energy() const { return best_energy_; }
  const std::vector<Chain<S>>& chains() const { return chains_; }
  const TemperatureLadder& ladder() const { return ladder_; }
  void forget_swaps() { ladder_.forget(); }

 private:
  struct Candidate {
    S state;
    double energy = 0;
  };

  void steps(size_t i) {
    Chain<S>& chain = chains_[i];
    std::optional<Candidate>& candidate = candidates_[i];
    double least = candidate ? candidate->energy : best_energy_;
    for (int64_t step = 0; step < options_.per_round; ++step) {
      chain.step();
      if (chain.energy() < least) {
        least = chain.energy();
        candidate = Candidate{chain.state(), least};
      }
    }
  }

  void keep_best(size_t i) {
    std::optional<Candidate>& candidate = candidates_[i];
    if (candidate && candidate->energy < best_energy_) {
      best_ = std::move(candidate->state);
      best_energy_ = candidate->energy;
    }
    candidate.reset();
  }

  /// Attempts swaps of neighbours, alternating between even and odd pairs.
  void exchange(bool adapt) {
    for (size_t i = odd_ ? 1 : 0; i + 1 < chains_.size(); i += 2) {
      Chain<S>&cold = chains_[i], &hot = chains_[i + 1];
      const double taken =
          ladder_.acceptance(static_cast<int>(i), cold.energy() / scale_, hot.energy() / scale_);
      const bool swap = swaps_.uniform() < taken;
      ladder_.count(static_cast<int>(i), taken, swap);
      if (swap) cold.swap_states(hot);
    }
    if (odd_ && adapt) {
      ladder_.adapt();
      set_scale(scale_);
    }
    odd_ = !odd_;
  }

  Options options_;
  double scale_ = 1;
  TemperatureLadder ladder_;
  std::vector<Chain<S>> chains_;
  std::vector<std::optional<Candidate>> candidates_ =
      std::vector<std::optional<Candidate>>(static_cast<size_t>(options_.chains));
  RandomStream swaps_;
  bool odd_ = false;
  S best_{};
  double best_energy_ = 0;
};

}  // namespace vug::inference
