#include <vug/fit/search/seeds.h>

#include <algorithm>
#include <limits>
#include <map>

namespace vug::fit {
namespace {

/// Where to begin with clusters: each may be what windows are made of.
std::vector<Gains> first_gains(const Evidence& evidence, bool of_looks) {
  if (of_looks) return {gains_of_looks()};
  std::vector<Gains> out;
  const Sums all = evidence.sums(0, 0, evidence.width(), evidence.height());
  const double pixels = static_cast<double>(evidence.width()) * evidence.height();
  // What is first is most likely (see ClusterImage); else whatever is not the most frequent.
  const auto lanes = all.lane.begin() + evidence.lanes();
  const auto most = std::max_element(all.lane.begin(), lanes) - all.lane.begin();
  for (int cluster = 0; cluster < evidence.lanes(); ++cluster) {
    if (cluster == most && cluster > 0) continue;
    Sums windows = all;
    // As if a quarter of the picture were windows, and six in ten of their pixels were of it.
    for (uint32_t& n : windows.lane) n = static_cast<uint32_t>(0.1 * n);
    windows.lane[static_cast<size_t>(cluster)] += static_cast<uint32_t>(0.15 * pixels);
    out.push_back(gains_of_regions(windows, all, evidence.lanes()));
  }
  return out;
}

/// What windows look like in a tree, as against the rest.
Gains learnt(const Model& model, const Evidence& evidence, const State& state) {
  Sums windows, wall = evidence.sums(0, 0, evidence.width(), evidence.height());
  model.each_terminal(state, [&](Look look, int, const Rect& r) {
    const Sums sums = evidence.sums(r.x0, r.y0, r.x1, r.y1);
    if (look == Look::window) windows += sums;
    wall -= sums;
  });
  return gains_of_regions(windows, wall, evidence.lanes());
}

}  // namespace

std::vector<State> seeds(const Workshop& shop, const Evidence& evidence, bool of_looks,
                         const SeedOptions& options) {
  std::vector<std::pair<double, State>> found;
  std::vector<std::pair<double, Gains>> learnt_gains;
  ParseOptions quick = options.parse;
  quick.depth = std::min(quick.depth, 1);
  // Clusters that lead to the same windows lead to the same gains.
  std::map<std::pair<Gains, int>, std::pair<double, State>> looked_at;
  const auto look = [&](const Gains& gains, const ParseOptions& how) {
    const auto [at, first] = looked_at.try_emplace({gains, how.depth});
    auto& [energy, state] = at->second;
    if (first) {
      state = parse(shop, evidence, gains, shop.model.start(), 0, how);
      energy = shop.model.energy(state);
    }
    found.push_back(at->second);
    return at->second;
  };
  // What windows look like is learnt from quick looks; the best of it is worth thorough ones.
  for (Gains gains : first_gains(evidence, of_looks)) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < options.rounds; ++round) {
      const auto [energy, state] = look(gains, quick);
      if (!(energy < least)) break;
      least = energy;
      if (!of_looks) gains = learnt(shop.model, evidence, state);
      learnt_gains.emplace_back(energy, gains);
    }
  }
  std::stable_sort(learnt_gains.begin(), learnt_gains.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::pair<double, State> best = {std::numeric_limits<double>::infinity(), {}};
  for (int i = 0; i < options.thorough && i < static_cast<int>(learnt_gains.size()); ++i) {
    auto seen = look(learnt_gains[static_cast<size_t>(i)].second, options.parse);
    if (seen.first < best.first) best = std::move(seen);
    if (of_looks) break;
  }
  if (!of_looks && best.first < std::numeric_limits<double>::infinity())
    look(learnt(shop.model, evidence, best.second), options.parse);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<State> out;
  for (auto& [energy, state] : found) out.push_back(std::move(state));
  return out;
}

}  // namespace vug::fit
