// SPDX-License-Identifier: Apache-2.0
// The graph of samples between which water can flow, and its edges' costs that do not depend on the
// direction.
#pragma once

#include <vug/base/vec.h>
#include <vug/karst/options.h>

#include <array>
#include <vector>

namespace vug::karst {

class Rock;

/// An edge seen from one of its ends.
struct Arc {
  int to = 0;
  int edge = 0;
};

/// An undirected graph; each edge joins one of the k nearest neighbours of a sample to it. The
/// graph is connected: parts without a common edge are joined by the shortest edge found.
struct SampleGraph {
  std::vector<Vec3d> points;
  std::vector<std::array<int, 2>> edges;  ///< Sorted, the smaller index first.
  std::vector<int> first;    ///< Start of each point's arcs, and the end of the last one.
  std::vector<Arc> arcs;     ///< Arcs of each point, by `to`.
  std::vector<double> cost;  ///< Cost of each edge, positive; see edge_costs.

  int size() const { return static_cast<int>(points.size()); }
  double length(int edge) const {
    const auto& [a, b] = edges[static_cast<size_t>(edge)];
    return (points[static_cast<size_t>(a)] - points[static_cast<size_t>(b)]).length();
  }
};

/// `more`: edges to add to those between neighbours, the smaller index first.
SampleGraph build_graph(std::vector<Vec3d> points, int neighbours,
                        const std::vector<std::array<int, 2>>& more = {});

/// Computes `first` and `arcs` from the edges.
void fill_arcs(SampleGraph& graph);

/// The cost of each edge in metres of unfavourable rock: the length times 1 plus the weights for
/// distance from beds, directions across joints, and rock that is not permeable, times a random
/// factor (paris2021karst, section 4, with the terms of gouy2024karstnsim). Legs through air have
/// a thousandfold cost. If there are edges along joints (sorted), only these follow joints.
std::vector<double> edge_costs(const SampleGraph& graph, const Rock& rock,
                               const KarstOptions& options,
                               const std::vector<std::array<int, 2>>& joint_edges = {});

}  // namespace vug::karst
