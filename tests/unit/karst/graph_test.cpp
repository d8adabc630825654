// SPDX-License-Identifier: Apache-2.0
// The parts of the generator: nearest neighbours, the graph of samples, searches, joints, layers.
#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/karst/joints.h>
#include <vug/karst/point_grid.h>
#include <vug/karst/search.h>

#include <algorithm>
#include <cmath>

namespace vug::karst {
namespace {

std::vector<Vec3d> random_points(int count, double height) {
  RandomStream random(RandomKey(7));
  std::vector<Vec3d> points;
  for (int i = 0; i < count; ++i) {
    const double x = random.uniform(-10, 10);
    const double y = height * random.uniform();
    points.emplace_back(x, y, random.uniform(0, 40));
  }
  return points;
}

TEST(PointGrid, FindsTheNearestLikeASearchOfAllPoints) {
  for (const double height : {0.0, 5.0, 300.0}) {
    std::vector<Vec3d> points = random_points(400, height);
    points.push_back(points[3]);                           // The same place twice.
    if (height > 100) points.emplace_back(500, 500, 500);  // An outlier.
    const PointGrid grid(points, 4);
    for (int index = 0; index < static_cast<int>(points.size()); ++index) {
      std::vector<std::pair<double, int>> all;
      for (size_t i = 0; i < points.size(); ++i)
        if (static_cast<int>(i) != index)
          all.emplace_back((points[i] - points[static_cast<size_t>(index)]).length2(),
                           static_cast<int>(i));
      std::sort(all.begin(), all.end());
      for (const int count : {1, 12, 60}) {
        const std::vector<int> found = grid.nearest(index, count);
        ASSERT_EQ(found.size(), static_cast<size_t>(count));
        for (size_t i = 0; i < found.size(); ++i) ASSERT_EQ(found[i], all[i].second) << index;
      }
    }
    EXPECT_EQ(grid.nearest(0, 1000).size(), points.size() - 1);
  }
}

/// The cost of the cheapest way by the algorithm of Bellman and Ford.
std::vector<double> relaxed_costs(const SampleGraph& graph, int source) {
  std::vector<double> cost(graph.points.size(), kInfinity);
  cost[static_cast<size_t>(source)] = 0;
  for (size_t round = 0; round < graph.points.size(); ++round)
    for (size_t e = 0; e < graph.edges.size(); ++e) {
      const auto a = static_cast<size_t>(graph.edges[e][0]);
      const auto b = static_cast<size_t>(graph.edges[e][1]);
      cost[b] = std::min(cost[b], cost[a] + graph.cost[e]);
      cost[a] = std::min(cost[a], cost[b] + graph.cost[e]);
    }
  return cost;
}

TEST(Search, FindsTheCheapestWays) {
  SampleGraph graph = build_graph(random_points(150, 5), 6);
  RandomStream random(RandomKey(3));
  for (size_t e = 0; e < graph.edges.size(); ++e) graph.cost.push_back(random.uniform(0.1, 3));
  const SearchTree tree = search(
      graph, 5, [&](int, const Arc& arc) { return graph.cost[static_cast<size_t>(arc.edge)]; },
      [](int) { return Visit::expand; });
  const std::vector<double> expected = relaxed_costs(graph, 5);
  for (size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(tree.cost[i], expected[i], 1e-9);
    const std::vector<int> path = tree.path_to(static_cast<int>(i));
    EXPECT_EQ(path.front(), 5);
    EXPECT_EQ(path.back(), static_cast<int>(i));
  }
}

TEST(Search, DoesNotPassBlockedPoints) {
  SampleGraph graph = build_graph({Vec3d(0.0), Vec3d(1, 0, 0), Vec3d(2, 0, 0)}, 1);
  const auto unit = [](int, const Arc&) { return 1.0; };
  const SearchTree tree =
      search(graph, 0, unit, [](int point) { return point == 1 ? Visit::block : Visit::expand; });
  EXPECT_EQ(tree.cost[1], 1);
  EXPECT_EQ(tree.cost[2], kInfinity);
  EXPECT_EQ(tree.reached, -1);
}

TEST(SampleGraph, JoinsSeparateGroups) {
  std::vector<Vec3d> points = random_points(40, 1);
  for (int i = 0; i < 40; ++i) points.push_back(points[static_cast<size_t>(i)] + Vec3d(1000, 0, 0));
  const SampleGraph graph = build_graph(points, 5);
  const SearchTree tree = search(
      graph, 0, [](int, const Arc&) { return 1.0; }, [](int) { return Visit::expand; });
  for (const double cost : tree.cost) EXPECT_LT(cost, kInfinity);
  for (size_t i = 0; i < graph.points.size(); ++i)
    EXPECT_GE(graph.first[i + 1] - graph.first[i], 5);
}

TEST(Joints, AreParallelPlanesAtTheirMeanSpacing) {
  const Joints joints({.azimuth = 0.4, .dip = 1.2, .spacing = 7}, RandomKey(1));
  EXPECT_NEAR(joints.normal().length(), 1, 1e-12);
  EXPECT_NEAR(joints.normal().dot(strike_vector(0.4)), 0, 1e-12);
  for (int64_t i = -50; i < 50; ++i) EXPECT_LT(joints.offset(i), joints.offset(i + 1));
  EXPECT_NEAR(joints.offset(1000) - joints.offset(0), 7000, 7);
  const Vec3d on_joint = joints.normal() * joints.offset(12) + strike_vector(0.4) * 30;
  EXPECT_NEAR(joints.distance(on_joint), 0, 1e-9);
  EXPECT_NEAR(joints.distance(on_joint + joints.normal() * 0.5), 0.5, 1e-9);
}

TEST(Layer, DipsTowardsItsAzimuth) {
  const Layer layer{.point = Vec3d(5, 10, 5), .dip = 0.3, .dip_azimuth = kPi / 2};
  EXPECT_NEAR(layer.height_at(5, 99), 10, 1e-12);
  EXPECT_NEAR(layer.height_at(6, 5), 10 - std::tan(0.3), 1e-12);  // East is +x.
  const Layer north{.point = Vec3d(0.0), .dip = 0.3};
  EXPECT_NEAR(north.height_at(0, -1), -std::tan(0.3), 1e-12);  // North is -z.
}

}  // namespace
}  // namespace vug::karst
