// SPDX-License-Identifier: Apache-2.0
// Shortest paths on the graph of samples. Ties are broken by the index, so the result depends on
// the costs only.
#pragma once

#include <vug/karst/sample_graph.h>

#include <algorithm>
#include <queue>

namespace vug::karst {

/// The tree of cheapest ways from one point.
struct SearchTree {
  std::vector<double> cost;      ///< Cost to each point; infinite if it was not reached.
  std::vector<int> parent;       ///< The point before it, -1 for the source.
  std::vector<int> parent_edge;  ///< The edge to it.
  int reached = -1;              ///< The point at which the search stopped, or -1.

  /// The points of the way from the source to `point`, in this order.
  std::vector<int> path_to(int point) const {
    std::vector<int> path;
    for (int i = point; i >= 0; i = parent[static_cast<size_t>(i)]) path.push_back(i);
    std::reverse(path.begin(), path.end());
    return path;
  }
};

enum class Visit {
  expand,  ///< Continue with the neighbours.
  block,   ///< Do not pass through this point.
  stop,    ///< The search ends here.
};

/// Dijkstra's algorithm: `cost(from, arc)` is the cost of an arc, positive, or infinite if it is
/// closed; `visit(point)` is called once for each point in the order of the costs.
template <class Cost, class VisitPoint>
SearchTree search(const SampleGraph& graph, int source, const Cost& cost, const VisitPoint& visit) {
  using Entry = std::pair<double, int>;
  const size_t count = graph.points.size();
  SearchTree tree{std::vector<double>(count, kInfinity), std::vector<int>(count, -1),
                  std::vector<int>(count, -1), -1};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  tree.cost[static_cast<size_t>(source)] = 0;
  queue.emplace(0.0, source);
  while (!queue.empty()) {
    const auto [so_far, point] = queue.top();
    queue.pop();
    const auto at = static_cast<size_t>(point);
    if (so_far > tree.cost[at]) continue;
    const Visit next = visit(point);
    if (next == Visit::stop) {
      tree.reached = point;
      break;
    }
    if (next == Visit::block) continue;
    for (int i = graph.first[at]; i < graph.first[at + 1]; ++i) {
      const Arc& arc = graph.arcs[static_cast<size_t>(i)];
      const double candidate = so_far + cost(point, arc);
      if (!(candidate < tree.cost[static_cast<size_t>(arc.to)])) continue;
      tree.cost[static_cast<size_t>(arc.to)] = candidate;
      tree.parent[static_cast<size_t>(arc.to)] = point;
      tree.parent_edge[static_cast<size_t>(arc.to)] = arc.edge;
      queue.emplace(candidate, arc.to);
    }
  }
  return tree;
}

}  // namespace vug::karst
