// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: the measured legs as a graph of points. Equated stations are one point.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>

#include <optional>
#include <vector>

namespace vug::survey {

/// A measured vector between two points.
struct Edge {
  int a = 0;
  int b = 0;
  Vec3d vector{0.0};
  Covariance covariance;
  int leg = -1;  ///< Index in the observations; -1 for a fix with a covariance.
};

struct LegGraph {
  int points = 0;
  std::vector<int> point_of;    ///< For each station.
  std::vector<int> station_of;  ///< The first station of each point; -1 for the place of a fix.
  std::vector<Edge> edges;
  std::vector<std::vector<int>> edges_of;       ///< For each point; an edge to itself twice.
  std::vector<std::optional<Vec3d>> positions;  ///< For each point; initially of fixed ones.
  /// The points of each component that is not fixed, other than the first component of a survey
  /// without fixes. Its first point is at the origin until `separate_components`.
  std::vector<std::vector<int>> loose;

  /// The other end of an edge.
  int across(int edge, int point) const {
    const Edge& e = edges[static_cast<size_t>(edge)];
    return e.a == point ? e.b : e.a;
  }
};

/// The graph with at least one fixed point in each component; see adjust.
LegGraph make_leg_graph(const Observations& observations, Diagnostics& warnings);

/// Moves each loose component, whose positions are relative, so that its bounding box lies east of
/// the rest with its south-western and lowest corner at the rest's latitude and height. Otherwise,
/// stations of unconnected surveys would share places.
void separate_components(LegGraph& graph);

}  // namespace vug::survey
