// SPDX-License-Identifier: Apache-2.0
// Graphs and networks whose measures are known in closed form.
#pragma once

#include <vug/network/graph.h>
#include <vug/network/network.h>

namespace vug::network {

inline Graph path_graph(int nodes) {
  Graph graph{nodes, {}};
  for (int i = 1; i < nodes; ++i) graph.edges.push_back({i - 1, i});
  return graph;
}

inline Graph star_graph(int nodes) {
  Graph graph{nodes, {}};
  for (int i = 1; i < nodes; ++i) graph.edges.push_back({0, i});
  return graph;
}

inline Graph ring_graph(int nodes) {
  Graph graph = path_graph(nodes);
  graph.edges.push_back({nodes - 1, 0});
  return graph;
}

inline Graph complete_graph(int nodes) {
  Graph graph{nodes, {}};
  for (int i = 0; i < nodes; ++i)
    for (int j = i + 1; j < nodes; ++j) graph.edges.push_back({i, j});
  return graph;
}

/// Adds a chain of stations to a network, joined by legs.
inline void add_chain(Network& network, const std::vector<Vec3d>& points) {
  for (size_t i = 0; i < points.size(); ++i) {
    const auto station = static_cast<int>(network.stations.size());
    network.stations.push_back({.position = points[i]});
    if (i > 0) network.legs.push_back({.from = station - 1, .to = station});
  }
}

inline void add_leg(Network& network, int from, int to) {
  network.legs.push_back({.from = from, .to = to});
}

}  // namespace vug::network
