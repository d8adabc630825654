// SPDX-License-Identifier: Apache-2.0
// Cheapest ways through graphs of any kind (Dijkstra). Ties are broken by the index, so the result
// depends on the costs only.
#pragma once

#include <vug/base/vec.h>

#include <algorithm>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

namespace vug {

/// The tree of cheapest ways from one node.
struct SearchTree {
  std::vector<double> cost;      ///< Cost to each node; infinite if it was not reached.
  std::vector<int> parent;       ///< The node before it, -1 for the source.
  std::vector<int> parent_edge;  ///< The edge to it.
  int reached = -1;              ///< The node at which the search stopped, or -1.

  /// The nodes of the way from the source to `node`, in this order.
  std::vector<int> path_to(int node) const {
    std::vector<int> path;
    for (int i = node; i >= 0; i = parent[static_cast<size_t>(i)]) path.push_back(i);
    std::reverse(path.begin(), path.end());
    return path;
  }
};

enum class Visit {
  expand,  ///< Continue with the neighbours.
  block,   ///< Do not pass through this node.
  stop,    ///< The search ends here.
};

/// Searches a graph of `count` nodes. `for_each_arc(node, relax)` calls relax(to, edge, cost) for
/// each arc that leaves a node; a cost is positive, or infinite if the arc is closed. `visit(node)`
/// is called once for each node in the order of the costs.
template <class ForEachArc, class VisitNode>
SearchTree shortest_paths(size_t count, int source, const ForEachArc& for_each_arc,
                          const VisitNode& visit) {
  using Entry = std::pair<double, int>;
  SearchTree tree{std::vector<double>(count, kInfinity), std::vector<int>(count, -1),
                  std::vector<int>(count, -1), -1};
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
  tree.cost[static_cast<size_t>(source)] = 0;
  queue.emplace(0.0, source);
  while (!queue.empty()) {
    const auto [so_far, node] = queue.top();
    queue.pop();
    if (so_far > tree.cost[static_cast<size_t>(node)]) continue;
    const Visit next = visit(node);
    if (next == Visit::stop) {
      tree.reached = node;
      break;
    }
    if (next == Visit::block) continue;
    for_each_arc(node, [&, so_far = so_far, node = node](int to, int edge, double cost) {
      const auto target = static_cast<size_t>(to);
      const double candidate = so_far + cost;
      if (!(candidate < tree.cost[target])) return;
      tree.cost[target] = candidate;
      tree.parent[target] = node;
      tree.parent_edge[target] = edge;
      queue.emplace(candidate, to);
    });
  }
  return tree;
}

}  // namespace vug
