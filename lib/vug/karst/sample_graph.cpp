// SPDX-License-Identifier: Apache-2.0
#include <vug/base/disjoint_sets.h>
#include <vug/base/parallel.h>
#include <vug/karst/point_grid.h>
#include <vug/karst/sample_graph.h>

#include <algorithm>

namespace vug::karst {
namespace {

constexpr size_t kGrain = 64;
constexpr int kMostProbes = 64;  ///< Points of a component from which the others are searched.

using Edge = std::array<int, 2>;

void sort_edges(std::vector<Edge>& edges) {
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

/// Joins each component but the first to the nearest point of another one.
void join_components(const std::vector<Vec3d>& points, std::vector<Edge>& edges) {
  DisjointSets<int> components(points.size());
  for (const auto& [a, b] : edges) components.join(a, b);
  for (size_t i = 1; i < points.size(); ++i) {
    // Roots are the first points of their components, so members are found from here on.
    if (components.root(static_cast<int>(i)) != static_cast<int>(i)) continue;
    std::vector<int> members;
    for (size_t j = i; j < points.size(); ++j)
      if (components.root(static_cast<int>(j)) == static_cast<int>(i))
        members.push_back(static_cast<int>(j));
    const size_t step = (members.size() + kMostProbes - 1) / kMostProbes;
    double least = kInfinity;
    Edge best{};
    for (size_t m = 0; m < members.size(); m += step)
      for (size_t j = 0; j < points.size(); ++j) {
        const double distance = (points[j] - points[static_cast<size_t>(members[m])]).length2();
        if (distance >= least || components.root(static_cast<int>(j)) == static_cast<int>(i))
          continue;
        least = distance;
        best = {std::min(members[m], static_cast<int>(j)),
                std::max(members[m], static_cast<int>(j))};
      }
    if (least == kInfinity) break;
    edges.push_back(best);
    components.join(best[0], best[1]);
  }
}

}  // namespace

void fill_arcs(SampleGraph& graph) {
  graph.first.assign(graph.points.size() + 1, 0);
  for (const auto& [a, b] : graph.edges) {
    ++graph.first[static_cast<size_t>(a) + 1];
    ++graph.first[static_cast<size_t>(b) + 1];
  }
  for (size_t i = 1; i < graph.first.size(); ++i) graph.first[i] += graph.first[i - 1];
  std::vector<int> next(graph.first.begin(), graph.first.end() - 1);
  graph.arcs.resize(graph.edges.size() * 2);
  for (size_t e = 0; e < graph.edges.size(); ++e) {
    const auto [a, b] = graph.edges[e];
    const int edge = static_cast<int>(e);
    graph.arcs[static_cast<size_t>(next[static_cast<size_t>(a)]++)] = {b, edge};
    graph.arcs[static_cast<size_t>(next[static_cast<size_t>(b)]++)] = {a, edge};
  }
  for (size_t i = 0; i < graph.points.size(); ++i)
    std::sort(graph.arcs.begin() + graph.first[i], graph.arcs.begin() + graph.first[i + 1],
              [](const Arc& a, const Arc& b) { return a.to < b.to; });
}

SampleGraph build_graph(std::vector<Vec3d> points, int neighbours,
                        const std::vector<std::array<int, 2>>& more) {
  SampleGraph graph;
  graph.points = std::move(points);
  const PointGrid grid(graph.points, 4);
  std::vector<std::vector<int>> near(graph.points.size());
  parallel_for(
      near.size(), [&](size_t i) { near[i] = grid.nearest(static_cast<int>(i), neighbours); },
      kGrain);
  for (size_t i = 0; i < near.size(); ++i)
    for (const int other : near[i])
      graph.edges.push_back(
          {std::min(static_cast<int>(i), other), std::max(static_cast<int>(i), other)});
  graph.edges.insert(graph.edges.end(), more.begin(), more.end());
  sort_edges(graph.edges);
  join_components(graph.points, graph.edges);
  sort_edges(graph.edges);
  fill_arcs(graph);
  return graph;
}

}  // namespace vug::karst
