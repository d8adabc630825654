// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/fit/search/sampler.h>

#include <algorithm>
#include <limits>

namespace vug::fit {
namespace {

void add_structure(const Rules& rules, const Tree& tree, int i, std::string& out) {
  out += rules.symbol(tree[i].symbol).name;
  if (tree[i].size == 1) return;
  out += '(';
  for (int part = i + 1; part < tree.end(i); part = tree.end(part)) {
    if (part > i + 1) out += ' ';
    add_structure(rules, tree, part, out);
  }
  out += ')';
}

}  // namespace

std::string structure_of(const Rules& rules, const Tree& tree) {
  std::string out;
  add_structure(rules, tree, 0, out);
  return out;
}

SamplerResult sample(const MoveContext& context, const SamplerOptions& options, RandomKey key,
                     Progress& progress, const std::vector<TreeState>& starts) {
  const Model& model = context.model;
  const inference::Moves<TreeState> all = moves(context);
  inference::TemperingOptions tempering;
  tempering.chains = options.chains;
  tempering.coldest = options.coldest;
  tempering.hottest = options.coldest * options.spread;
  tempering.per_round = options.per_round;
  inference::Tempering<TreeState> chains(
      all, [&model] { return [&model](TreeState& state) { return model.energy(state); }; },
      starts.empty() ? std::vector<TreeState>{model.axiom_state()} : starts, key, tempering);
  const int64_t rounds = std::max<int64_t>(1, options.steps / options.per_round);
  const auto warm = static_cast<int64_t>(options.warm_up * static_cast<double>(rounds));
  double reported = std::numeric_limits<double>::infinity();
  const auto report = [&] {
    if (!options.improved || !(chains.best_energy() < reported)) return;
    reported = chains.best_energy();
    options.improved(chains.best(), reported);
  };
  report();
  if (!progress.cancelled()) progress.begin("sampling", static_cast<uint64_t>(rounds));
  for (int64_t round = 0; round < warm && !progress.cancelled(); ++round) {
    const double left = 1 - static_cast<double>(round) / static_cast<double>(warm);
    chains.set_scale(maths::pow(options.annealing, left));
    chains.run(1, true, progress);
    report();
  }
  chains.set_scale(1);
  chains.forget_swaps();
  SamplerResult out;
  std::map<std::string, std::vector<size_t>> seen;  // Rounds of each structure.
  // The temperature of the coldest chain is fixed; those of the others adapt with decreasing steps,
  // which preserves the limit distribution (cite roberts2007). If adaptation stopped before the
  // best basin is found, chains would rarely leave it again.
  chains.run(rounds - warm, true, progress, [&](const TreeState& state, double energy) {
    out.trace.push_back(energy);
    double elements = 0;
    model.each_terminal(state, [&](RegionType, int, const Rect&) { ++elements; });
    out.elements.push_back(elements);
    seen[structure_of(model.rules(), state.tree)].push_back(out.trace.size() - 1);
    report();
  });
  out.stopped = progress.cancelled();
  if (!out.stopped) progress.end();
  out.best = chains.best();
  out.bits = chains.best_energy();
  for (const auto& [text, when] : seen)
    out.structures.push_back({text, static_cast<int64_t>(when.size())});
  std::stable_sort(
      out.structures.begin(), out.structures.end(),
      [](const StructureCount& a, const StructureCount& b) { return a.rounds > b.rounds; });
  out.visited.resize(out.trace.size());
  for (size_t i = 0; i < out.structures.size(); ++i)
    for (const size_t round : seen.at(out.structures[i].text))
      out.visited[round] = static_cast<int>(i);
  out.swaps = chains.ladder().swaps();
  for (int i = 0; i < options.chains; ++i)
    out.temperatures.push_back(chains.ladder().temperature(i));
  out.moves = chains.chains().front().counts();
  return out;
}

}  // namespace vug::fit
