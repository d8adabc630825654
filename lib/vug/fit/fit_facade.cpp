// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/fit/fit_facade.h>
#include <vug/fit/naming.h>
#include <vug/fit/polish/polish.h>

#include <algorithm>
#include <numeric>

namespace vug::fit {
namespace {

/// Seeds may be worse than the best one by this share of what it saves.
constexpr double kMaxSeedLoss = 0.05;
/// Number of seeds that are refined and given to the chains.
constexpr int kMaxStarts = 4;

/// Keeps the first `count` distinct seeds that cost at most `worst`.
void keep_distinct_seeds(const Model& model, std::vector<TreeState>& seeds, size_t count,
                         double worst) {
  std::vector<TreeState> out;
  for (TreeState& seed : seeds) {
    if (out.size() == count || (!out.empty() && model.energy(seed) > worst)) break;
    if (std::none_of(out.begin(), out.end(),
                     [&](const TreeState& other) { return other.tree == seed.tree; }))
      out.push_back(std::move(seed));
  }
  seeds = std::move(out);
}

}  // namespace

FitResult fit_facade(const Evidence& evidence, const Rules& rules, const FitOptions& options,
                     RandomKey key, Progress& progress) {
  if (options.runs < 1)
    throw Error(ErrorCode::bad_input, "invalid number of runs: must be at least 1");
  const LikelihoodPtr likelihood = make_likelihood(options.likelihood, evidence);
  const Model model(rules, options.limits, evidence.width(), evidence.height(),
                    {&evidence, likelihood, options.pixel_weight});
  const EdgeHints hints = likelihood->is_supervised() ? EdgeHints::from_supervised(evidence)
                                                      : EdgeHints::from_clusters(evidence);
  const MoveContext context{model, hints};
  TreeState wall = model.axiom_state();
  const double wall_bits = model.energy(wall);
  std::vector<TreeState> starts =
      seeds(context, evidence, likelihood->is_supervised(), options.seeds);
  if (starts.empty()) starts.push_back(wall);
  const double seed_bits = model.energy(starts.front());
  keep_distinct_seeds(model, starts, static_cast<size_t>(std::max(options.runs, kMaxStarts)),
                      seed_bits + kMaxSeedLoss * std::max(0.0, wall_bits - seed_bits));
  std::vector<double> bits(starts.size());
  parallel_for(starts.size(), [&](size_t start) {
    bits[start] = polish(context, evidence, starts[start], progress).after;
  });
  std::vector<size_t> order(starts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return bits[a] < bits[b]; });

  std::vector<SamplerResult> runs;
  TreeState best = starts[order.front()];
  double chain_bits = seed_bits;
  for (int run = 0; run < options.runs && !(run > 0 && progress.cancelled()); ++run) {
    // The coldest chain of each run begins with a seed of its own, the others with all seeds.
    std::vector<TreeState> own;
    for (size_t k = 0; k < order.size(); ++k)
      own.push_back(starts[order[(static_cast<size_t>(run) + k) % order.size()]]);
    runs.push_back(sample(context, options.sampler, key.at("run").at(static_cast<uint64_t>(run)),
                          progress, own));
    TreeState found = runs.back().best;
    chain_bits = std::min(chain_bits, runs.back().bits);
    polish(context, evidence, found, progress);
    replace_if_cheaper(model, best, std::move(found));
  }
  name_elements(model, evidence, best);

  FitResult out;
  out.tree = best.tree;
  model.each_terminal(best, [&](RegionType type, int node, const Rect& rect) {
    out.elements.push_back({type, node, rect});
  });
  out.report = make_report(runs);
  out.report.supervised = likelihood->is_supervised();
  out.report.bits = model.energy(best);
  out.report.wall_bits = wall_bits;
  out.report.seed_bits = seed_bits;
  out.report.chain_bits = chain_bits;
  add_score(out.report, model, evidence, best.tree);
  return out;
}

}  // namespace vug::fit
