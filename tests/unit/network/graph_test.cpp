// SPDX-License-Identifier: Apache-2.0
// Closed forms of the graph measures.
#include "graphs.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vug::network {
namespace {

TEST(GraphMeasures, StarsHaveOneDominantNode) {
  for (const int n : {3, 5, 12}) {
    const Graph star = star_graph(n);
    EXPECT_DOUBLE_EQ(central_point_dominance(star), 1) << n;
    EXPECT_DOUBLE_EQ(degree_correlation(star), -1) << n;
    EXPECT_DOUBLE_EQ(mean_path_length(star), 2.0 * (n - 1) / n) << n;
    EXPECT_DOUBLE_EQ(mean_degree(star), 2.0 * (n - 1) / n) << n;
    EXPECT_EQ(cycle_count(star), 0) << n;
  }
  EXPECT_DOUBLE_EQ(mean_degree(star_graph(5)), 1.6);
  EXPECT_NEAR(degree_variation(star_graph(5)), 0.8385, 5e-5);
}

TEST(GraphMeasures, PathsHaveLongWaysAndAMiddle) {
  for (const int n : {2, 3, 4, 5, 20})
    EXPECT_NEAR(mean_path_length(path_graph(n)), (n + 1) / 3.0, 1e-12) << n;
  EXPECT_DOUBLE_EQ(central_point_dominance(path_graph(3)), 1);
  EXPECT_NEAR(central_point_dominance(path_graph(4)), 4.0 / 9, 1e-12);
  EXPECT_NEAR(central_point_dominance(path_graph(5)), 5.0 / 12, 1e-12);
}

TEST(GraphMeasures, RingsAndCompleteGraphsAreRegular) {
  for (const int n : {3, 5, 9}) {
    const Graph ring = ring_graph(n);
    EXPECT_DOUBLE_EQ(mean_degree(ring), 2);
    EXPECT_EQ(degree_variation(ring), 0);
    EXPECT_EQ(degree_correlation(ring), 1);
    EXPECT_NEAR(central_point_dominance(ring), 0, 1e-12);
    EXPECT_EQ(cycle_count(ring), 1);
    EXPECT_NEAR(mean_path_length(ring), (n + 1) / 4.0, 1e-12);
    const Graph complete = complete_graph(n);
    EXPECT_DOUBLE_EQ(mean_path_length(complete), 1);
    EXPECT_NEAR(central_point_dominance(complete), 0, 1e-12);
    EXPECT_EQ(cycle_count(complete), (n - 1) * (n - 2) / 2);
  }
}

TEST(GraphMeasures, PathLengthIsTheMeanOfComponentsByNodes) {
  Graph graph = path_graph(4);  // Mean 5/3.
  graph.nodes = 6;
  graph.edges.push_back({4, 5});  // Mean 1.
  EXPECT_NEAR(mean_path_length(graph), (4 * 5.0 / 3 + 2 * 1.0) / 6, 1e-12);
  EXPECT_EQ(component_count(components(graph)), 2);
  EXPECT_EQ(components(graph), (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

TEST(GraphMeasures, AreUndefinedWithoutNodes) {
  const Graph none;
  EXPECT_TRUE(std::isnan(mean_degree(none)));
  EXPECT_TRUE(std::isnan(degree_variation(none)));
  EXPECT_TRUE(std::isnan(degree_correlation(none)));
  EXPECT_TRUE(std::isnan(mean_path_length(none)));
  EXPECT_TRUE(std::isnan(central_point_dominance(none)));
  EXPECT_EQ(cycle_count(none), 0);
}

}  // namespace
}  // namespace vug::network
