#include <vug/fit/seeds.h>

#include <algorithm>
#include <limits>

namespace vug::fit {
namespace {

/// Where to begin with clusters: each may be what windows are made of.
std::vector<Gains> first_gains(const Evidence& evidence, bool of_looks) {
  if (of_looks) return {gains_of_looks()};
  std::vector<Gains> out;
  const Sums all = evidence.sums(0, 0, evidence.width(), evidence.height());
  const double pixels = static_cast<double>(evidence.width()) * evidence.height();
  // By day windows are among what is darker.
  for (int cluster = 0; 2 * cluster < evidence.lanes(); ++cluster) {
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
  for (Gains gains : first_gains(evidence, of_looks)) {
    double least = std::numeric_limits<double>::infinity();
    for (int round = 0; round < options.rounds; ++round) {
      State state = parse(shop, evidence, gains, shop.model.start(), 0, options.parse);
      const double energy = shop.model.energy(state);
      if (!(energy < least)) break;
      least = energy;
      if (!of_looks) gains = learnt(shop.model, evidence, state);
      found.emplace_back(energy, std::move(state));
    }
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<State> out;
  for (auto& [energy, state] : found) out.push_back(std::move(state));
  return out;
}

}  // namespace vug::fit
