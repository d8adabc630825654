#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/fit/naming.h>
#include <vug/fit/polish/polish.h>
#include <vug/fit/read.h>

#include <algorithm>
#include <numeric>

namespace vug::fit {
namespace {

/// How much of what a seed saves others may be behind the best one.
constexpr double kWorthARun = 0.05;

/// The first of the seeds, as many as that, that cost no more than `worst` and are no twins.
void keep_worthy(const Model& model, std::vector<State>& seeds, size_t count, double worst) {
  std::vector<State> out;
  for (State& seed : seeds) {
    if (out.size() == count || (!out.empty() && model.energy(seed) > worst)) break;
    if (std::none_of(out.begin(), out.end(),
                     [&](const State& other) { return other.tree == seed.tree; }))
      out.push_back(std::move(seed));
  }
  seeds = std::move(out);
}

}  // namespace

Reading read(const Evidence& evidence, const Rules& rules, const ReadOptions& options,
             RandomKey key, Progress& progress) {
  if (options.runs < 1) throw Error(ErrorCode::bad_input, "a facade is read by at least one run");
  const LikelihoodPtr likelihood = make_likelihood(options.likelihood, evidence);
  const Model model(rules, options.limits, evidence.width(), evidence.height(), &evidence,
                    likelihood, options.trust);
  const Hints hints =
      likelihood->of_looks() ? Hints::of_looks(evidence) : Hints::of_clusters(evidence);
  const Workshop shop{model, hints};
  State wall = model.start();
  const double wall_bits = model.energy(wall);
  std::vector<State> starts = seeds(shop, evidence, likelihood->of_looks(), options.seeds);
  if (starts.empty()) starts.push_back(wall);
  const double seed_bits = model.energy(starts.front());
  keep_worthy(model, starts, static_cast<size_t>(options.runs),
              seed_bits + kWorthARun * std::max(0.0, wall_bits - seed_bits));
  std::vector<double> bits(starts.size());
  parallel_for(starts.size(), [&](size_t start) {
    bits[start] = polish(shop, evidence, starts[start], progress).after;
  });
  std::vector<size_t> order(starts.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return bits[a] < bits[b]; });

  std::vector<Sampled> runs;
  State best = starts[order.front()];
  double chain_bits = seed_bits;
  for (int run = 0; run < options.runs && !(run > 0 && progress.cancelled()); ++run) {
    const State& start = starts[order[static_cast<size_t>(run) % order.size()]];
    runs.push_back(sample(shop, options.sampler, key.at("run").at(static_cast<uint64_t>(run)),
                          progress, &start));
    State found = runs.back().best;
    chain_bits = std::min(chain_bits, runs.back().bits);
    polish(shop, evidence, found, progress);
    take_cheaper(model, best, std::move(found));
  }
  name_elements(model, evidence, best);

  Reading out;
  out.tree = best.tree;
  model.each_terminal(best, [&](Look look, int node, const Rect& rect) {
    out.seen.push_back({look, node, rect});
  });
  out.report = report_of(runs);
  out.report.bits = model.energy(best);
  out.report.wall_bits = wall_bits;
  out.report.seed_bits = seed_bits;
  out.report.chain_bits = chain_bits;
  add_score(out.report, model, evidence, best.tree);
  return out;
}

}  // namespace vug::fit
