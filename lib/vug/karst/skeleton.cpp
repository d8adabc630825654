// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/parallel.h>
#include <vug/karst/search.h>
#include <vug/karst/skeleton.h>

#include <cmath>

namespace vug::karst {
namespace {

constexpr int kNearest = 16;  ///< Only ways to this number of nearest key points count.

/// Adds the passages of a way; passages that exist keep their flow.
void add_path(const FlowCost& cost, const std::vector<int>& path, Plan& plan) {
  for (size_t i = 1; i < path.size(); ++i) {
    const int edge = plan.edge_between(path[i - 1], path[i]);
    if (plan.has(edge)) continue;
    const int tier = cost.nearest_tier(path[i]);
    // Without a known flow the higher end is upstream.
    const bool falls = cost.above_table(0, path[i - 1]) >= cost.above_table(0, path[i]);
    plan.set(edge, {.from = falls ? path[i - 1] : path[i],
                    .stage = cost.stage(tier, path[i - 1], path[i]),
                    .tier = tier});
  }
}

/// The ways from one key point to the nearest others.
struct Ways {
  std::vector<double> cost;  ///< To each key point; infinite if it is not near.
  std::vector<std::vector<int>> path;
};

Ways ways_from(const FlowCost& cost, const std::vector<int>& points,
               const std::vector<int>& key_of_point, size_t key, const SampleGraph& graph) {
  Ways ways{std::vector<double>(points.size(), kInfinity),
            std::vector<std::vector<int>>(points.size())};
  int found = 0;
  const SearchTree tree = search(
      graph, points[key], [&](int from, const Arc& arc) { return cost.anywhere(from, arc); },
      [&](int point) {
        if (key_of_point[static_cast<size_t>(point)] >= 0) ++found;
        return found > kNearest ? Visit::stop : Visit::expand;
      });
  for (size_t other = 0; other < points.size(); ++other) {
    const auto at = static_cast<size_t>(points[other]);
    // Points that the search touched, but did not finish, may have a cheaper way.
    const double limit =
        tree.reached < 0 ? kInfinity : tree.cost[static_cast<size_t>(tree.reached)];
    if (other == key || !(tree.cost[at] < kInfinity) || tree.cost[at] > limit) continue;
    ways.cost[other] = tree.cost[at];
    ways.path[other] = tree.path_to(points[other]);
  }
  return ways;
}

}  // namespace

void add_skeleton(const FlowCost& cost, const std::vector<int>& points, double gamma, Plan& plan) {
  const SampleGraph& graph = plan.graph();
  std::vector<int> key_of_point(graph.points.size(), -1);
  for (size_t key = 0; key < points.size(); ++key)
    key_of_point[static_cast<size_t>(points[key])] = static_cast<int>(key);
  std::vector<Ways> ways(points.size());
  parallel_for(ways.size(),
               [&](size_t key) { ways[key] = ways_from(cost, points, key_of_point, key, graph); });
  const auto power = [&](size_t i, size_t j) {
    const double d = std::min(ways[i].cost[j], ways[j].cost[i]);
    return d < kInfinity ? maths::pow(d, gamma) : kInfinity;
  };
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t j = i + 1; j < points.size(); ++j) {
      const double direct = power(i, j);
      bool kept = direct < kInfinity;
      for (size_t k = 0; k < points.size() && kept; ++k)
        kept = k == i || k == j || !(power(i, k) + power(k, j) < direct);
      if (!kept) continue;
      const bool forward = ways[i].cost[j] <= ways[j].cost[i];
      add_path(cost, forward ? ways[i].path[j] : ways[j].path[i], plan);
    }
  connect(cost, points, plan);
}

void connect(const FlowCost& cost, const std::vector<int>& points, Plan& plan) {
  if (points.empty()) return;
  // The part that contains the first point; the others are joined to it one after the other.
  const SampleGraph& graph = plan.graph();
  std::vector<int> network = plan.points();
  if (network.empty()) network.push_back(points.front());
  const int start = plan.contains(points.front()) ? points.front() : network.front();
  for (const int point : points) {
    const SearchTree part = search(
        graph, start, [&](int, const Arc& arc) { return plan.has(arc.edge) ? 1.0 : kInfinity; },
        [&](int at) { return at == point ? Visit::stop : Visit::expand; });
    if (part.reached == point) continue;
    const SearchTree way = search(
        graph, point, [&](int from, const Arc& arc) { return cost.anywhere(from, arc); },
        [&](int at) {
          return part.cost[static_cast<size_t>(at)] < kInfinity ? Visit::stop : Visit::expand;
        });
    add_path(cost, way.path_to(way.reached), plan);
  }
}

}  // namespace vug::karst
