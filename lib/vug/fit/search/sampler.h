// SPDX-License-Identifier: Apache-2.0
// Markov chain Monte Carlo over facade trees, with the default number of chains, steps and
// temperatures.
#pragma once

#include <vug/base/progress.h>
#include <vug/fit/move.h>
#include <vug/inference/tempering.h>

#include <functional>
#include <map>

namespace vug::fit {

struct SamplerOptions {
  int chains = 8;
  /// Temperature; above 1 it weights pixels less, since they are not independent.
  double coldest = 1;
  double spread = 3;     ///< Initial ratio of the hottest to the coldest temperature.
  double annealing = 1;  ///< Initial temperature factor of all chains; 1 when starting from seeds.
  int64_t steps = 1'000'000;  ///< Steps per chain.
  double warm_up = 0.7;       ///< Share of the steps used for warm-up, without recording.
  int64_t per_round = 100;    ///< Steps between two exchanges.
  /// Receives the best state so far and its energy in bits after each round that improved it, on
  /// the thread that samples. It must not throw.
  std::function<void(const TreeState& best, double bits)> improved = {};
};

/// Number of rounds spent in trees of one structure, which differ in numbers only.
struct StructureCount {
  std::string text;  ///< For example "Facade(RegularGrid(Window Window))".
  int64_t rounds = 0;
};

struct SamplerResult {
  TreeState best;   ///< State of least energy.
  double bits = 0;  ///< Energy of `best`.
  /// Structures of the coldest chain, most frequent first.
  std::vector<StructureCount> structures;
  std::vector<double> trace;     ///< Energy of the coldest chain after each round.
  std::vector<double> elements;  ///< Number of its visible elements after each round.
  std::vector<int> visited;      ///< Index into `structures` for each round.
  std::vector<inference::TemperatureLadder::Swaps> swaps;
  std::vector<double> temperatures;
  /// Counts of the coldest chain, in the order of move_kinds.
  std::vector<inference::MoveCount> moves;
  bool stopped = false;  ///< Cancelled; the result is the best so far.
};

/// Samples trees by parallel tempering. The chains, from the coldest on, begin with the starts in
/// turn, or with the axiom. The result does not depend on the number of threads. If cancelled it
/// returns the results so far.
SamplerResult sample(const MoveContext& context, const SamplerOptions& options, RandomKey key,
                     Progress& progress = Progress::none(),
                     const std::vector<TreeState>& starts = {});

/// The symbols of a tree without its numbers.
std::string structure_of(const Rules& rules, const Tree& tree);

}  // namespace vug::fit
