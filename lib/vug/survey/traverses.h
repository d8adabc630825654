// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: divides the graph of legs into traverses between junctions, and dead ends.
#pragma once

#include <vug/survey/leg_graph.h>

namespace vug::survey {

/// A chain of edges between two junctions; a junction is a fixed point or one with more than two
/// edges.
struct TraverseChain {
  int from = 0;
  int to = 0;
  std::vector<int> edges;
  std::vector<bool> forwards;  ///< Whether each edge is passed from a to b.
  bool bridge = false;         ///< Not part of a loop and not between fixed points.
};

/// An edge whose end `point` has no other connection to a fixed point.
struct DeadEnd {
  int edge = 0;
  int point = 0;
};

struct Traverses {
  std::vector<TraverseChain> chains;
  std::vector<DeadEnd> dead_ends;  ///< From the outermost inwards.
};

Traverses find_traverses(const LegGraph& graph);

}  // namespace vug::survey
