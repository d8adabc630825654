#include <vug/fit/polish.h>
#include <vug/fit/read.h>

namespace vug::fit {

Reading read(const Evidence& evidence, const Rules& rules, const ReadOptions& options,
             RandomKey key, Progress& progress) {
  const LikelihoodPtr likelihood = make_likelihood(options.likelihood, evidence);
  const Model model(rules, options.limits, evidence.width(), evidence.height(), &evidence,
                    likelihood, options.trust);
  const Hints hints =
      likelihood->of_looks() ? Hints::of_looks(evidence) : Hints::of_clusters(evidence);
  const Workshop shop{model, hints};
  Reading out;
  State start = model.start();
  out.seed_bits = out.wall_bits = model.energy(start);
  for (State& seed : seeds(shop, evidence, likelihood->of_looks(), options.seeds)) {
    const double bits = model.energy(seed);
    if (bits >= out.seed_bits) continue;
    out.seed_bits = bits;
    start = std::move(seed);
  }
  out.sampled = sample(shop, options.sampler, key, progress, &start);
  State best = out.sampled.best;
  out.chain_bits = out.sampled.bits;
  out.bits = polish(shop, evidence, best, progress).after;
  out.tree = best.tree;
  out.complexity = model.complexity(out.tree);
  model.each_terminal(best, [&](Look look, int node, const Rect& rect) {
    out.seen.push_back({look, node, rect});
  });
  return out;
}

}  // namespace vug::fit
