// SPDX-License-Identifier: Apache-2.0
// Simple undirected graphs and their measures, without positions. The measures follow
// collon2017karst in the form of the karstnet documentation of 2021.
#pragma once

#include <array>
#include <limits>
#include <vector>

namespace vug::network {

/// The value of a measure that is undefined.
inline constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

/// Nodes 0..nodes-1, joined by edges without loops; two nodes have at most one edge.
struct Graph {
  int nodes = 0;
  std::vector<std::array<int, 2>> edges;
};

/// The neighbours of each node, in the order of the edges.
std::vector<std::vector<int>> neighbours(const Graph& graph);

/// The component of each node; components count from 0 in the order of their first node.
std::vector<int> components(const Graph& graph);

/// Number of components of a result of `components`.
int component_count(const std::vector<int>& component_of_node);

/// Number of independent cycles: edges - nodes + components.
int cycle_count(const Graph& graph);

/// Mean number of edges at a node; NaN without nodes.
double mean_degree(const Graph& graph);

/// Standard deviation of the degree (with N - 1) divided by its mean; NaN below two nodes.
double degree_variation(const Graph& graph);

/// Pearson's correlation of the degrees at the two ends of edges, each edge in both directions; 1
/// if all degrees are equal.
double degree_correlation(const Graph& graph);

/// Mean number of edges on the shortest paths between two nodes of the same component: the mean of
/// the components, weighted by their numbers of nodes. NaN without edges.
double mean_path_length(const Graph& graph);

/// The mean of B_max - B_i over all nodes but one, where B is the betweenness of a node, normalised
/// by the number of pairs of other nodes. NaN below three nodes.
double central_point_dominance(const Graph& graph);

}  // namespace vug::network
