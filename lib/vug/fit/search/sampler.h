// Facades out of pictures: chains that look for the trees a picture is likely to be of.
#pragma once

#include <vug/base/progress.h>
#include <vug/fit/move.h>
#include <vug/inference/tempering.h>

#include <map>

namespace vug::fit {

struct SamplerOptions {
  int chains = 8;
  double coldest = 1;    ///< Pixels are no independent witnesses: above 1 trusts them less.
  double spread = 3;     ///< Temperature of the hottest chain by that of the coldest, at first.
  double annealing = 1;  ///< How much hotter all chains begin than they end; from seeds: as hot.
  int64_t steps = 1'000'000;  ///< Of each chain.
  double warm_up = 0.7;       ///< Share of the steps in which they cool, and nothing is told of.
  int64_t per_round = 100;    ///< Steps between two exchanges.
};

/// How often chains were in trees that differ in numbers only.
struct StructureCount {
  std::string text;  ///< "Facade(RegularGrid(Window Window))"
  int64_t rounds = 0;
};

struct SamplerResult {
  TreeState best;                          ///< Of least energy.
  double bits = 0;                         ///< Its energy.
  std::vector<StructureCount> structures;  ///< Of the coldest chain, the most frequent first.
  std::vector<double> trace;               ///< Energies of the coldest chain after each round,
  std::vector<int> visited;                ///< and places of its structures in `structures`.
  std::vector<inference::TemperatureLadder::Swaps> swaps;
  std::vector<double> temperatures;
  std::vector<inference::MoveCount> moves;  ///< Of the coldest chain, in the order of move_kinds.
  bool stopped = false;                     ///< Told to stop: the best so far.
};

/// Samples trees by parallel tempering from the axiom, or from `start`. The same result for any
/// number of threads. When told to stop it returns what it has.
SamplerResult sample(const MoveContext& context, const SamplerOptions& options, RandomKey key,
                     Progress& progress = Progress::none(), const TreeState* start = nullptr);

/// A tree's symbols, without its numbers.
std::string structure_of(const Rules& rules, const Tree& tree);

}  // namespace vug::fit
