// SPDX-License-Identifier: Apache-2.0
// The passages of a network that grows on the graph of samples.
#pragma once

#include <vug/karst/sample_graph.h>
#include <vug/network/network.h>

namespace vug::karst {

/// A passage on an edge of the graph. Water runs from `from` to the other end.
struct Passage {
  int from = -1;  ///< -1: the edge is not a passage.
  network::Stage stage = network::Stage::unknown;
  int tier = 0;
  double discharge = 0;  ///< Relative flow of the tier that used the passage last.
  int water_tier = 0;    ///< The tier that used the passage last.
  bool water = false;    ///< On the way from a sink to a spring, so it is never removed.
};

class Plan {
 public:
  explicit Plan(const SampleGraph& graph)
      : graph_(graph), passages_(graph.edges.size()), degree_(graph.points.size(), 0) {}

  const SampleGraph& graph() const { return graph_; }
  const Passage& passage(int edge) const { return passages_[static_cast<size_t>(edge)]; }
  bool has(int edge) const { return passage(edge).from >= 0; }
  bool contains(int point) const { return degree_[static_cast<size_t>(point)] > 0; }
  int degree(int point) const { return degree_[static_cast<size_t>(point)]; }

  /// Adds a passage, or changes the one on the edge.
  void set(int edge, const Passage& passage);
  void remove(int edge);

  /// The other end of an edge.
  int other_end(int edge, int point) const;
  /// The edge between two points; -1 if there is none.
  int edge_between(int a, int b) const;

  /// The points with passages, in order.
  std::vector<int> points() const;
  /// The passages as a network whose stations are `points()` and whose legs follow the order of the
  /// edges.
  network::Network network() const;

 private:
  const SampleGraph& graph_;
  std::vector<Passage> passages_;
  std::vector<int> degree_;
};

}  // namespace vug::karst
