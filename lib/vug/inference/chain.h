// SPDX-License-Identifier: Apache-2.0
// Reversible-jump Markov chain (cite green1995): the Metropolis-Hastings rule over states of
// variable size. States consist of integers only, so no Jacobian is needed.
#pragma once

#include <vug/inference/bits.h>
#include <vug/inference/choices.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace vug::inference {

/// A kind of move over states S. `propose` changes the state in place, makes its choices with
/// `forward`, and scores with `back` the choices of the same move that lead from the new state to
/// the old one. It returns false if the move is not applicable or leaves the state space; the state
/// is then unspecified.
template <class S>
struct Move {
  std::string name;
  double weight = 1;  ///< Relative frequency of proposals of this move.
  std::function<bool(S&, Choices& forward, Choices& back)> propose;
};
template <class S>
using Moves = std::vector<Move<S>>;

struct MoveCount {
  int64_t tried = 0;     ///< Number of proposals,
  int64_t possible = 0;  ///< of those that led to a valid state,
  int64_t accepted = 0;  ///< and of those that were accepted.
};

/// The logarithm of the proposal ratio q(new to old) / q(old to new).
inline double ln_ratio(const Choices& forward, const Choices& back) {
  return back.ln_probability() - forward.ln_probability();
}

/// A Markov chain with the stationary distribution 2^(-energy / temperature). The energy is a code
/// length in bits; `energy(S&)` may cache results in the state.
template <class S>
class Chain {
 public:
  using Energy = std::function<double(S&)>;
  struct Options {
    double temperature = 1;
    bool use_proposal_ratio = true;  ///< False is wrong; it only shows that tests detect the error.
  };

  /// The moves must outlive the chain.
  Chain(const Moves<S>& moves, Energy energy, S start, RandomKey key, Options options = {})
      : moves_(moves),
        of_(std::move(energy)),
        state_(std::move(start)),
        stream_(key),
        options_(options),
        counts_(moves.size()) {
    for (const Move<S>& move : moves_) weights_.push_back(move.weight);
    which_ = DiscreteDistribution(weights_);
    energy_ = of_(state_);
  }

  void step() {
    const auto which = static_cast<size_t>(which_.find(0, which_.size(), stream_.uniform()));
    ++counts_[which].tried;
    before_ = state_;
    forward_.draw(stream_);
    back_.score();
    if (!moves_[which].propose(state_, forward_, back_)) return reject();
    ++counts_[which].possible;
    const double energy = of_(state_);
    double ln = kLn2 * (energy_ - energy) / options_.temperature;
    if (options_.use_proposal_ratio) ln += ln_ratio(forward_, back_);
    if (!(ln >= 0) && !(stream_.uniform() < maths::exp(ln))) return reject();
    ++counts_[which].accepted;
    energy_ = energy;
  }

  const S& state() const { return state_; }
  double energy() const { return energy_; }
  double temperature() const { return options_.temperature; }
  void set_temperature(double temperature) { options_.temperature = temperature; }
  const std::vector<MoveCount>& counts() const { return counts_; }

  /// Swaps states and energies; temperatures, random streams and counts stay.
  void swap_states(Chain& other) {
    std::swap(state_, other.state_);
    std::swap(energy_, other.energy_);
  }

 private:
  void reject() { std::swap(state_, before_); }

  const Moves<S>& moves_;
  Energy of_;
  S state_, before_{};
  double energy_ = 0;
  RandomStream stream_;
  Options options_;
  std::vector<double> weights_;
  DiscreteDistribution which_;
  Choices forward_, back_;
  std::vector<MoveCount> counts_;
};

}  // namespace vug::inference
