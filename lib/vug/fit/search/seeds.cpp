// SPDX-License-Identifier: Apache-2.0
#include <vug/fit/search/seeds.h>

#include <algorithm>
#include <limits>
#include <map>

namespace vug::fit {
namespace {

/// Start values for clusters: each cluster may be that of the windows.
std::vector<Gains> first_gains(const Evidence& evidence, bool supervised) {
  if (supervised) return {supervised_gains()};
  std::vector<Gains> out;
  const Sums all = evidence.sums(0, 0, evidence.width(), evidence.height());
  const double pixels = static_cast<double>(evidence.width()) * evidence.height();
  // The first cluster is the most likely one (see ClusterImage); all others except the most
  // frequent are tried as well.
  const auto lanes = all.lane.begin() + evidence.lanes();
  const auto most = std::max_element(all.lane.begin(), lanes) - all.lane.begin();
  for (int cluster = 0; cluster < evidence.lanes(); ++cluster) {
    if (cluster == most && cluster > 0) continue;
    Sums windows = all;
    // Assumes that a quarter of the picture is windows and that six in ten of their pixels are in
    // this cluster.
    for (uint32_t& n : windows.lane) n = static_cast<uint32_t>(0.1 * n);
    windows.lane[static_cast<size_t>(cluster)] += static_cast<uint32_t>(0.15 * pixels);
    out.push_back(gains_from_regions(windows, all, evidence.lanes()));
  }
  return out;
}

/// Gains estimated from the windows of a tree and the rest of the picture.
Gains estimated_gains(const Model& model, const Evidence& evidence, const TreeState& state) {
  Sums windows, wall = evidence.sums(0, 0, evidence.width(), evidence.height());
  model.each_terminal(state, [&](RegionType type, int, const Rect& r) {
    const Sums sums = evidence.sums(r.x0, r.y0, r.x1, r.y1);
    if (type == RegionType::window) windows += sums;
    wall -= sums;
  });
  return gains_from_regions(windows, wall, evidence.lanes());
}

}  // namespace

std::vector<TreeState> seeds(const MoveContext& context, const Evidence& evidence, bool supervised,
                             const SeedOptions& options) {
  std::vector<std::pair<double, TreeState>> found;
  std::vector<std::pair<double, Gains>> gain_candidates;
  ParseOptions quick = options.parse;
  quick.depth = std::min(quick.depth, 1);
  // Different clusters may lead to the same windows and thus to the same gains.
  std::map<std::pair<Gains, int>, std::pair<double, TreeState>> parsed;
  const auto parse_once = [&](const Gains& gains, const ParseOptions& how) {
    const auto [at, first] = parsed.try_emplace({gains, how.depth});
    auto& [energy, state] = at->second;
    if (first) {
      state = parse(context, evidence, gains, context.model.axiom_state(), 0, how);
      energy = context.model.energy(state);
    }
    found.push_back(at->second);
    return at->second;
  };
  // Gains are estimated from quick parses; the best of them are parsed at full depth.
  for (Gains gains : first_gains(evidence, supervised)) {
    double lowest = std::numeric_limits<double>::infinity();
    for (int round = 0; round < options.rounds; ++round) {
      const auto [energy, state] = parse_once(gains, quick);
      if (!(energy < lowest)) break;
      lowest = energy;
      if (!supervised) gains = estimated_gains(context.model, evidence, state);
      gain_candidates.emplace_back(energy, gains);
    }
  }
  std::stable_sort(gain_candidates.begin(), gain_candidates.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::pair<double, TreeState> best = {std::numeric_limits<double>::infinity(), {}};
  for (int i = 0; i < options.thorough && i < static_cast<int>(gain_candidates.size()); ++i) {
    auto seen = parse_once(gain_candidates[static_cast<size_t>(i)].second, options.parse);
    if (seen.first < best.first) best = std::move(seen);
    if (supervised) break;
  }
  if (!supervised && best.first < std::numeric_limits<double>::infinity())
    parse_once(estimated_gains(context.model, evidence, best.second), options.parse);
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<TreeState> out;
  for (auto& [energy, state] : found) out.push_back(std::move(state));
  return out;
}

}  // namespace vug::fit
