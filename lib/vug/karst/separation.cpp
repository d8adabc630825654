// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/karst/segment_grid.h>
#include <vug/karst/separation.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::karst {
namespace {

/// Distance of edges that may conflict, in separations: that of coincident key points.
constexpr double kReach = kMeeting;
constexpr int kRounds = 4;  ///< Selections of edges until no key point is cut off.

class EdgeSelection {
 public:
  EdgeSelection(const SampleGraph& graph, int key_points, double separation, double side)
      : graph_(graph),
        stations_(stations_of_points(graph.points, key_points, kMeeting * separation)),
        separation_(separation),
        grid_(side, kReach * separation) {}

  void add(int edge) { grid_.add(edge, segment(edge)); }

  bool add_if_separate(int edge) {
    const auto conflicts = [&](int other) { return conflict(edge, other); };
    if (grid_.any_near(segment(edge), conflicts)) return false;
    add(edge);
    return true;
  }

 private:
  SegmentPiece segment(int edge) const {
    const auto& [a, b] = graph_.edges[static_cast<size_t>(edge)];
    return {graph_.points[static_cast<size_t>(a)], graph_.points[static_cast<size_t>(b)]};
  }

  bool conflict(int edge, int other) const {
    const SegmentPiece a = segment(edge), b = segment(other);
    if (are_far_apart(a, b)) return false;
    for (const int i : graph_.edges[static_cast<size_t>(edge)])
      for (const int j : graph_.edges[static_cast<size_t>(other)])
        if (stations_[static_cast<size_t>(i)] == stations_[static_cast<size_t>(j)])
          return nearly_parallel(away(edge, i), away(other, j), kLeastSine);
    return distance2(a, b) < separation_ * separation_;
  }

  /// Whether the bounding boxes show that two edges are separate; most are.
  bool are_far_apart(const SegmentPiece& a, const SegmentPiece& b) const {
    for (int axis = 0; axis < 3; ++axis) {
      const auto [a_low, a_high] = std::minmax(a.from[axis], a.to[axis]);
      const auto [b_low, b_high] = std::minmax(b.from[axis], b.to[axis]);
      if (a_low > b_high + kReach * separation_ || b_low > a_high + kReach * separation_)
        return true;
    }
    return false;
  }

  /// The vector of an edge away from one of its ends.
  Vec3d away(int edge, int end) const {
    const auto& [a, b] = graph_.edges[static_cast<size_t>(edge)];
    return graph_.points[static_cast<size_t>(a == end ? b : a)] -
           graph_.points[static_cast<size_t>(end)];
  }

  const SampleGraph& graph_;
  std::vector<int> stations_;
  double separation_;
  SegmentGrid grid_;
};

/// The first edges in the order that join all parts with key points, over other parts if necessary.
/// Parts without key points to which no such way leads remain dry.
std::vector<int> joins(const SampleGraph& graph, int key_points, const std::vector<int>& order,
                       DisjointSets<int> parts) {
  DisjointSets<int> joined = parts;
  std::vector<int> tree;
  for (const int edge : order) {
    const auto& [a, b] = graph.edges[static_cast<size_t>(edge)];
    if (joined.join(a, b)) tree.push_back(edge);
  }
  std::vector<int> degree(graph.points.size(), 0);
  std::vector<bool> needed(graph.points.size(), false);
  for (int i = 0; i < key_points; ++i) needed[static_cast<size_t>(parts.root(i))] = true;
  const auto part = [&](int edge, int end) {
    const auto& ends = graph.edges[static_cast<size_t>(edge)];
    return static_cast<size_t>(parts.root(ends[static_cast<size_t>(end)]));
  };
  for (const int edge : tree)
    for (const int end : {0, 1}) ++degree[part(edge, end)];
  for (bool removed = true; removed;) {
    const auto is_dry = [&](int edge) {
      for (const int end : {0, 1})
        if (degree[part(edge, end)] == 1 && !needed[part(edge, end)]) return true;
      return false;
    };
    removed = false;
    std::erase_if(tree, [&](int edge) {
      if (!is_dry(edge)) return false;
      for (const int end : {0, 1}) --degree[part(edge, end)];
      return removed = true;
    });
  }
  return tree;
}

}  // namespace

std::vector<int> stations_of_points(const std::vector<Vec3d>& points, int key_points,
                                    double distance) {
  std::vector<int> stations(points.size());
  std::iota(stations.begin(), stations.end(), 0);
  for (int i = 0; i < key_points; ++i)
    for (int j = 0; j < i; ++j) {
      const Vec3d apart = points[static_cast<size_t>(i)] - points[static_cast<size_t>(j)];
      if (apart.length2() >= distance * distance || stations[static_cast<size_t>(j)] != j) continue;
      stations[static_cast<size_t>(i)] = j;
      break;
    }
  return stations;
}

SampleGraph separated(SampleGraph graph, int key_points, double separation) {
  const size_t count = graph.edges.size();
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return std::pair(graph.cost[static_cast<size_t>(a)], a) <
           std::pair(graph.cost[static_cast<size_t>(b)], b);
  });
  double total = 0;
  for (size_t e = 0; e < count; ++e) total += graph.length(static_cast<int>(e));
  const double side = std::max(separation, total / static_cast<double>(std::max<size_t>(1, count)));
  // Edges without which key points would be cut off come first, so that others keep away from them.
  std::vector<bool> kept;
  std::vector<int> first;
  for (int round = 0; round < kRounds; ++round) {
    EdgeSelection selection(graph, key_points, separation, side);
    DisjointSets<int> parts(graph.points.size());
    kept.assign(count, false);
    for (const int edge : first) {
      selection.add(edge);
      kept[static_cast<size_t>(edge)] = true;
    }
    for (const int edge : order) {
      const auto e = static_cast<size_t>(edge);
      kept[e] = kept[e] || selection.add_if_separate(edge);
      if (kept[e]) parts.join(graph.edges[e][0], graph.edges[e][1]);
    }
    const std::vector<int> missing = joins(graph, key_points, order, parts);
    for (const int edge : missing) kept[static_cast<size_t>(edge)] = true;
    if (missing.empty()) break;
    first.insert(first.end(), missing.begin(), missing.end());
  }
  size_t end = 0;
  for (size_t e = 0; e < count; ++e) {
    if (!kept[e]) continue;
    graph.edges[end] = graph.edges[e];
    graph.cost[end++] = graph.cost[e];
  }
  graph.edges.resize(end);
  graph.cost.resize(end);
  fill_arcs(graph);
  return graph;
}

}  // namespace vug::karst
