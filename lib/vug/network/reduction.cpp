// SPDX-License-Identifier: Apache-2.0
#include <vug/network/reduction.h>

#include <algorithm>
#include <map>
#include <set>

namespace vug::network {
namespace {

using Pair = std::array<int, 2>;

Pair sorted(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// Follows branches over the nodes of a cave graph, each edge once.
class BranchWalk {
 public:
  explicit BranchWalk(const Graph& graph) : adjacent_(neighbours(graph)) {}

  std::vector<std::vector<int>> branches(std::vector<int>& nodes) {
    for (size_t i = 0; i < adjacent_.size(); ++i)
      if (adjacent_[i].size() != 2) add_branches_at(static_cast<int>(i), nodes);
    // The rest are rings without junctions.
    for (size_t i = 0; i < adjacent_.size(); ++i)
      if (!used_.contains(sorted(static_cast<int>(i), adjacent_[i].front())))
        add_branches_at(static_cast<int>(i), nodes);
    return std::move(branches_);
  }

 private:
  void add_branches_at(int node, std::vector<int>& nodes) {
    nodes.push_back(node);
    for (const int next : adjacent_[static_cast<size_t>(node)])
      if (!used_.contains(sorted(node, next))) branches_.push_back(follow(node, next));
  }

  std::vector<int> follow(int node, int next) {
    std::vector<int> chain{node, next};
    used_.insert(sorted(node, next));
    while (chain.back() != node && adjacent_[static_cast<size_t>(chain.back())].size() == 2) {
      const std::vector<int>& ways = adjacent_[static_cast<size_t>(chain.back())];
      const int onward = ways[0] == chain[chain.size() - 2] ? ways[1] : ways[0];
      used_.insert(sorted(chain.back(), onward));
      chain.push_back(onward);
    }
    return chain;
  }

  std::vector<std::vector<int>> adjacent_;
  std::set<Pair> used_;
  std::vector<std::vector<int>> branches_;
};

/// The number of inner stations that a branch keeps in the simple graph.
int kept_stations(const Branch& branch, const std::map<Pair, int>& branches_of_pair) {
  if (branch.is_loop()) return 2;
  const bool parallel =
      branches_of_pair.at(sorted(branch.stations.front(), branch.stations.back())) > 1;
  return parallel && branch.stations.size() > 2 ? 1 : 0;
}

Graph simple_graph(const Reduction& reduction) {
  std::map<int, int> node_of_station;
  for (const int station : reduction.nodes)
    node_of_station.emplace(station, static_cast<int>(node_of_station.size()));
  std::map<Pair, int> branches_of_pair;
  for (const Branch& branch : reduction.branches)
    ++branches_of_pair[sorted(branch.stations.front(), branch.stations.back())];
  Graph graph{static_cast<int>(reduction.nodes.size()), {}};
  for (const Branch& branch : reduction.branches) {
    int from = node_of_station.at(branch.stations.front());
    for (int kept = kept_stations(branch, branches_of_pair); kept > 0; --kept) {
      graph.edges.push_back({from, graph.nodes});
      from = graph.nodes++;
    }
    graph.edges.push_back({from, node_of_station.at(branch.stations.back())});
  }
  return graph;
}

double length_of(const std::vector<int>& stations, const Network& network) {
  double length = 0;
  for (size_t i = 1; i < stations.size(); ++i)
    length += (network.stations[static_cast<size_t>(stations[i])].position -
               network.stations[static_cast<size_t>(stations[i - 1])].position)
                  .length();
  return length;
}

}  // namespace

PlacedGraph cave_graph(const Network& network) {
  require_valid(network);
  PlacedGraph cave;
  std::set<Pair> seen;
  std::vector<Pair> edges;
  for (const Leg& leg : network.legs)
    if (!leg.surface && !leg.duplicate && leg.from != leg.to &&
        seen.insert(sorted(leg.from, leg.to)).second)
      edges.push_back({leg.from, leg.to});
  for (const auto& [a, b] : edges) cave.stations.insert(cave.stations.end(), {a, b});
  std::sort(cave.stations.begin(), cave.stations.end());
  cave.stations.erase(std::unique(cave.stations.begin(), cave.stations.end()), cave.stations.end());
  const auto node_of = [&](int station) {
    return static_cast<int>(std::lower_bound(cave.stations.begin(), cave.stations.end(), station) -
                            cave.stations.begin());
  };
  cave.graph.nodes = static_cast<int>(cave.stations.size());
  for (const auto& [a, b] : edges) cave.graph.edges.push_back({node_of(a), node_of(b)});
  return cave;
}

Reduction reduce(const Network& network) { return reduce(network, cave_graph(network)); }

Reduction reduce(const Network& network, const PlacedGraph& cave) {
  Reduction reduction;
  for (std::vector<int>& chain : BranchWalk(cave.graph).branches(reduction.nodes)) {
    for (int& node : chain) node = cave.stations[static_cast<size_t>(node)];
    const double length = length_of(chain, network);
    reduction.branches.push_back({std::move(chain), length});
  }
  for (int& node : reduction.nodes) node = cave.stations[static_cast<size_t>(node)];
  reduction.graph = simple_graph(reduction);
  return reduction;
}

}  // namespace vug::network
