// SPDX-License-Identifier: Apache-2.0
// Shortest paths on the graph of samples.
#pragma once

#include <vug/base/shortest_paths.h>
#include <vug/karst/sample_graph.h>

namespace vug::karst {

/// As shortest_paths in base: `cost(from, arc)` is the cost of an arc.
template <class Cost, class VisitPoint>
SearchTree search(const SampleGraph& graph, int source, const Cost& cost, const VisitPoint& visit) {
  const auto for_each_arc = [&](int point, const auto& relax) {
    const auto at = static_cast<size_t>(point);
    for (int i = graph.first[at]; i < graph.first[at + 1]; ++i) {
      const Arc& arc = graph.arcs[static_cast<size_t>(i)];
      relax(arc.to, arc.edge, cost(point, arc));
    }
  };
  return shortest_paths(graph.points.size(), source, for_each_arc, visit);
}

}  // namespace vug::karst
