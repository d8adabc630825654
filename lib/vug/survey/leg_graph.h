// SPDX-License-Identifier: Apache-2.0
// Internal to adjust: the measured legs as a graph of points. Equated stations are one point.
#pragma once

#include <vug/base/diagnostics.h>
#include <vug/survey/observations.h>

#include <optional>
#include <span>
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

/// The edges of each point in their order, all in one array; an edge from a point to itself twice.
class IncidentEdges {
 public:
  IncidentEdges() = default;
  IncidentEdges(size_t points, const std::vector<Edge>& edges);

  std::span<const int> operator[](size_t point) const {
    return {edges_.data() + starts_[point], edges_.data() + starts_[point + 1]};
  }

 private:
  std::vector<size_t> starts_ = {0};  ///< One more than points.
  std::vector<int> edges_;
};

struct LegGraph {
  int points = 0;
  std::vector<int> point_of;    ///< For each station.
  std::vector<int> station_of;  ///< The first station of each point; -1 for the place of a fix.
  std::vector<Edge> edges;
  IncidentEdges edges_of;
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
