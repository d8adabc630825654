// SPDX-License-Identifier: Apache-2.0
// Measures of a graph that need the shortest paths between all pairs of nodes.
#include <vug/network/graph.h>

#include <algorithm>

namespace vug::network {
namespace {

/// A breadth-first search from one node, with the counts that Brandes' algorithm needs.
struct Search {
  std::vector<int> order;     ///< The reached nodes by increasing distance.
  std::vector<int> distance;  ///< In edges; -1 for nodes that are not reached.
  std::vector<double> paths;  ///< Numbers of shortest paths from the first node.
};

Search search_from(size_t first, const std::vector<std::vector<int>>& adjacent) {
  Search search{
      {}, std::vector<int>(adjacent.size(), -1), std::vector<double>(adjacent.size(), 0.0)};
  search.order.push_back(static_cast<int>(first));
  search.distance[first] = 0;
  search.paths[first] = 1;
  for (size_t i = 0; i < search.order.size(); ++i) {
    const auto node = static_cast<size_t>(search.order[i]);
    for (const int next_node : adjacent[node]) {
      const auto next = static_cast<size_t>(next_node);
      if (search.distance[next] < 0) {
        search.distance[next] = search.distance[node] + 1;
        search.order.push_back(next_node);
      }
      if (search.distance[next] == search.distance[node] + 1)
        search.paths[next] += search.paths[node];
    }
  }
  return search;
}

/// Adds the part of each shortest path from the search's first node that passes through a node
/// (brandes2001, equation 6). Both directions of a pair are counted.
void add_dependencies(const Search& search, const std::vector<std::vector<int>>& adjacent,
                      std::vector<double>& betweenness) {
  std::vector<double> dependency(adjacent.size(), 0.0);
  for (size_t i = search.order.size(); i-- > 1;) {
    const auto node = static_cast<size_t>(search.order[i]);
    for (const int before_node : adjacent[node]) {
      const auto before = static_cast<size_t>(before_node);
      if (search.distance[before] != search.distance[node] - 1) continue;
      dependency[before] += search.paths[before] / search.paths[node] * (1 + dependency[node]);
    }
    betweenness[node] += dependency[node];
  }
}

}  // namespace

double mean_path_length(const Graph& graph) {
  if (graph.edges.empty()) return kUndefined;
  const auto adjacent = neighbours(graph);
  double sum = 0;
  for (size_t first = 0; first < adjacent.size(); ++first) {
    const Search search = search_from(first, adjacent);
    if (search.order.size() < 2) continue;
    long long edges = 0;
    for (const int node : search.order) edges += search.distance[static_cast<size_t>(node)];
    sum += static_cast<double>(edges) / static_cast<double>(search.order.size() - 1);
  }
  return sum / graph.nodes;
}

double central_point_dominance(const Graph& graph) {
  if (graph.nodes < 3) return kUndefined;
  const auto adjacent = neighbours(graph);
  std::vector<double> betweenness(adjacent.size(), 0.0);
  for (size_t first = 0; first < adjacent.size(); ++first)
    add_dependencies(search_from(first, adjacent), adjacent, betweenness);
  const double most = *std::max_element(betweenness.begin(), betweenness.end());
  double sum = 0;
  for (const double value : betweenness) sum += most - value;
  const double nodes = graph.nodes;
  return sum / ((nodes - 1) * (nodes - 2) * (nodes - 1));
}

}  // namespace vug::network
