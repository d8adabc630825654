// SPDX-License-Identifier: Apache-2.0
// The removal of a passage that closes a loop.
#include <vug/karst/growth.h>
#include <vug/network/reduction.h>

#include <algorithm>

namespace vug::karst {
namespace {

constexpr double kGap = 0.1;  ///< Half the removed part of a cut passage, in its number of legs.

/// The edges of each branch that has no way of water.
std::vector<std::vector<int>> dry_branches(const Plan& plan) {
  const std::vector<int> points = plan.points();
  std::vector<std::vector<int>> branches;
  for (const network::Branch& branch : network::reduce(plan.network()).branches) {
    std::vector<int> edges;
    for (size_t i = 1; i < branch.stations.size(); ++i)
      edges.push_back(plan.edge_between(points[static_cast<size_t>(branch.stations[i - 1])],
                                        points[static_cast<size_t>(branch.stations[i])]));
    const bool dry =
        std::none_of(edges.begin(), edges.end(), [&](int e) { return plan.passage(e).water; });
    if (dry) branches.push_back(std::move(edges));
  }
  return branches;
}

/// Whether the ends of an edge are joined by passages without it.
bool is_on_loop(const Plan& plan, int edge) {
  const auto& [start, goal] = plan.graph().edges[static_cast<size_t>(edge)];
  std::vector<bool> seen(plan.graph().points.size(), false);
  std::vector<int> stack{start};
  seen[static_cast<size_t>(start)] = true;
  while (!stack.empty()) {
    const auto at = static_cast<size_t>(stack.back());
    stack.pop_back();
    for (int i = plan.graph().first[at]; i < plan.graph().first[at + 1]; ++i) {
      const Arc& arc = plan.graph().arcs[static_cast<size_t>(i)];
      if (arc.edge == edge || !plan.has(arc.edge) || seen[static_cast<size_t>(arc.to)]) continue;
      if (arc.to == goal) return true;
      seen[static_cast<size_t>(arc.to)] = true;
      stack.push_back(arc.to);
    }
  }
  return false;
}

}  // namespace

bool cut_loop(RandomStream& random, Plan& plan) {
  std::vector<std::vector<int>> branches = dry_branches(plan);
  while (!branches.empty()) {
    const auto choice = random.below(static_cast<uint32_t>(branches.size()));
    const std::vector<int>& edges = branches[choice];
    if (is_on_loop(plan, edges.front())) {
      const auto count = static_cast<double>(edges.size());
      const double middle = random.uniform(0, count);
      const auto begin = static_cast<size_t>(std::max(0.0, middle - kGap * count));
      const auto end =
          std::min(edges.size(), std::max(begin + 1, static_cast<size_t>(middle + kGap * count)));
      for (size_t i = begin; i < end; ++i) plan.remove(edges[i]);
      return true;
    }
    branches.erase(branches.begin() + choice);
  }
  return false;
}

}  // namespace vug::karst
