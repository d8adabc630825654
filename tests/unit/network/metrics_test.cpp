// SPDX-License-Identifier: Apache-2.0
#include "graphs.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/metrics.h>
#include <vug/network/reduction.h>

#include <cmath>

namespace vug::network {
namespace {

/// A grid of 3 x 3 stations with unit legs along x and z.
Network grid() {
  Network network;
  for (int i = 0; i < 9; ++i) network.stations.push_back({.position = Vec3d(i % 3, 0, i / 3)});
  for (int i = 0; i < 9; ++i) {
    if (i % 3 < 2) add_leg(network, i, i + 1);
    if (i / 3 < 2) add_leg(network, i, i + 3);
  }
  return network;
}

TEST(NetworkMetrics, AGridHasTwoAzimuths) {
  const Metrics metrics = measure(grid());
  EXPECT_NEAR(metrics.orientation_entropy, std::log(2) / std::log(18), 1e-12);
  EXPECT_NEAR(metrics.orientation_entropy, 0.2398, 5e-5);
  EXPECT_EQ(metrics.cycles, 4);
  EXPECT_EQ(metrics.nodes, 5);  // The corners have two legs.
  EXPECT_EQ(metrics.edges, 8);
  EXPECT_DOUBLE_EQ(metrics.length, 12);
}

TEST(NetworkMetrics, UniformAzimuthsHaveEntropyOne) {
  Network network;
  network.stations.push_back({});
  for (int bin = 0; bin < 18; ++bin) {
    // Alternate halves of the circle: opposite directions belong to the same bin.
    const double azimuth = (bin * 10 + 5 + (bin % 2) * 180) * kPi / 180;
    network.stations.push_back({.position = Vec3d(std::sin(azimuth), bin, -std::cos(azimuth))});
    add_leg(network, 0, bin + 1);
  }
  EXPECT_NEAR(measure(network).orientation_entropy, 1, 1e-12);
}

TEST(NetworkMetrics, OrientationIgnoresShafts) {
  Network network = grid();
  network.stations.push_back({.position = Vec3d(0, -50, 0)});
  add_leg(network, 0, 9);
  EXPECT_NEAR(measure(network).orientation_entropy, std::log(2) / std::log(18), 1e-12);
}

TEST(NetworkMetrics, EqualLengthsHaveEntropyZero) {
  Network network;
  network.stations.push_back({});
  for (int i = 0; i < 4; ++i) {
    network.stations.push_back(
        {.position = Vec3d(i < 2 ? 3 - 6 * i : 0, i == 2 ? 3 : 0, i == 3 ? 3 : 0)});
    add_leg(network, 0, i + 1);
  }
  const Metrics metrics = measure(network);
  EXPECT_EQ(metrics.length_entropy, 0);
  EXPECT_EQ(metrics.length_variation, 0);
  EXPECT_DOUBLE_EQ(metrics.branch_length, 3);
  EXPECT_DOUBLE_EQ(metrics.tortuosity, 1);
}

TEST(NetworkMetrics, LengthsFallIntoTenBins) {
  Network network;
  network.stations.push_back({});
  const double lengths[] = {1, 5, 10, 10};
  for (int i = 0; i < 4; ++i) {
    network.stations.push_back({.position = Vec3d(lengths[i], 0, i)});
    network.stations.back().position *= lengths[i] / network.stations.back().position.length();
    add_leg(network, 0, i + 1);
  }
  const Metrics metrics = measure(network);
  EXPECT_NEAR(metrics.length_entropy, 1.5 * std::log10(2), 1e-12);  // 1/4, 1/4, 1/2.
  EXPECT_NEAR(metrics.length_variation, std::sqrt((30.25 + 2.25 + 2 * 12.25) / 3) / 6.5, 1e-12);
}

TEST(NetworkMetrics, ASemicircleHasTortuosityHalfPi) {
  Network network;
  std::vector<Vec3d> points;
  for (int i = 0; i <= 1000; ++i)
    points.emplace_back(std::cos(i * kPi / 1000), 0, std::sin(i * kPi / 1000));
  add_chain(network, points);
  EXPECT_NEAR(measure(network).tortuosity, kPi / 2, 1e-5);
}

TEST(NetworkReduction, LoopsAndParallelBranchesStaySimple) {
  Network network;
  add_chain(network, {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(2, 0, 0)});
  network.stations.push_back({.position = Vec3d(0, 0, 1)});  // A second way from 0 to 2.
  add_leg(network, 0, 3);
  add_leg(network, 3, 2);
  add_leg(network, 0, 2);  // A third and direct way.
  network.stations.push_back({.position = Vec3d(3, 0, 0)});
  network.stations.push_back({.position = Vec3d(3, 0, 1)});
  add_leg(network, 2, 4);
  add_leg(network, 4, 5);
  add_leg(network, 5, 2);  // A loop at 2.
  const Reduction reduction = reduce(network);
  EXPECT_EQ(reduction.nodes, (std::vector<int>{0, 2}));
  ASSERT_EQ(reduction.branches.size(), 4u);
  EXPECT_EQ(reduction.graph.nodes, 6);  // Two for the loop, one for each bent branch.
  EXPECT_EQ(reduction.graph.edges.size(), 8u);
  EXPECT_EQ(cycle_count(reduction.graph), 3);
  EXPECT_EQ(measure(network).cycles, 3);
}

TEST(NetworkReduction, ARingWithoutJunctionsIsALoop) {
  Network network;
  add_chain(network, {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(1, 0, 1), Vec3d(0, 0, 1)});
  add_leg(network, 3, 0);
  const Reduction reduction = reduce(network);
  ASSERT_EQ(reduction.branches.size(), 1u);
  EXPECT_TRUE(reduction.branches[0].is_loop());
  EXPECT_DOUBLE_EQ(reduction.branches[0].length, 4);
  const Metrics metrics = measure(network);
  EXPECT_EQ(metrics.cycles, 1);
  EXPECT_TRUE(std::isnan(metrics.tortuosity));
  EXPECT_EQ(metrics.nodes, 3);
}

TEST(NetworkReduction, IgnoresRepeatedSurfaceAndDuplicateLegs) {
  Network network;
  add_chain(network, {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(2, 0, 0), Vec3d(3, 0, 0)});
  add_leg(network, 1, 0);
  add_leg(network, 2, 2);
  network.legs[2].surface = true;
  network.legs.push_back({.from = 0, .to = 2, .duplicate = true});
  const Metrics metrics = measure(network);
  EXPECT_EQ(metrics.legs, 2);
  EXPECT_EQ(metrics.stations, 3);
  EXPECT_EQ(metrics.components, 1);
  EXPECT_DOUBLE_EQ(metrics.length, 2);
}

TEST(NetworkMetrics, AnEmptyNetworkHasNoMeasures) {
  const Metrics metrics = measure({});
  EXPECT_EQ(metrics.legs, 0);
  EXPECT_TRUE(std::isnan(metrics.orientation_entropy));
  EXPECT_TRUE(std::isnan(metrics.branch_length));
  EXPECT_TRUE(std::isnan(metrics.degree));
}

}  // namespace
}  // namespace vug::network
