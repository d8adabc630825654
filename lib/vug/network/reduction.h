// SPDX-License-Identifier: Apache-2.0
// The reduced graph of a network: junctions and ends, joined by branches.
#pragma once

#include <vug/network/graph.h>
#include <vug/network/network.h>

namespace vug::network {

/// A chain of stations between two nodes of the reduced graph, which are its first and last one. A
/// loop starts and ends at the same station.
struct Branch {
  std::vector<int> stations;
  double length = 0;  ///< Metres along the legs.

  bool is_loop() const { return stations.front() == stations.back(); }
};

struct Reduction {
  std::vector<int> nodes;  ///< The stations whose number of legs is not 2.
  std::vector<Branch> branches;
  /// The nodes and branches as a simple graph. To stay simple, a loop keeps two of its inner
  /// stations as nodes, and a branch parallel to another one keeps one, unless it has none.
  Graph graph;
};

/// Legs over the surface, duplicate legs, legs from a station to itself and all but the first leg
/// between two stations are ignored, and with them stations without other legs. A ring without
/// junctions is a loop at its first station. Branches start at nodes in the order of the stations,
/// and with legs in the order of the network. Throws like require_valid.
Reduction reduce(const Network& network);

/// The stations and legs that `reduce` uses, as a graph with the stations of its nodes.
struct PlacedGraph {
  Graph graph;
  std::vector<int> stations;  ///< The station of each node, in ascending order.
};
/// Throws like require_valid.
PlacedGraph cave_graph(const Network& network);

/// The reduced graph of a network whose cave graph is known.
Reduction reduce(const Network& network, const PlacedGraph& cave);

}  // namespace vug::network
