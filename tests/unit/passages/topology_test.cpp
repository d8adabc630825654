// SPDX-License-Identifier: Apache-2.0
// The surface of a cave has as many handles as its network has independent cycles.
#include "../scan/external_data.h"
#include "passage_samples.h"
#include "surface_topology.h"

#include <vug/base/error.h>
#include <vug/network/dat.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace vug::passages {
namespace {

void expect_genus(const network::Network& network, size_t genus, double voxel,
                  const PassageOptions& options = {}) {
  const mesh::Topology topology = topology_of(passages(network, options), voxel);
  EXPECT_EQ(topology.components, 1u);
  ASSERT_TRUE(topology.genus.has_value());
  EXPECT_EQ(*topology.genus, genus);
  EXPECT_EQ(topology.boundary_edges, 0u);
}

/// Published networks, which are not part of this project.
void check_published(const std::string& name, double radius, size_t genus, double voxel) {
  const std::filesystem::path nodes = external_data() / "surveys" / "karst" / (name + "_nodes.dat");
  if (!std::filesystem::exists(nodes))
    GTEST_SKIP() << "set VUG_EXTERNAL_DATA to a folder with surveys/karst";
  expect_genus(with_radius(network::read_dat(nodes), radius), genus, voxel);
}

TEST(PublishedNetwork, HuttesIsOneRing) { check_published("Huttes", 0.5, 1, 0.2); }
TEST(PublishedNetwork, GorgeIsATree) { check_published("gorge", 5, 0, 1.5); }
TEST(PublishedNetwork, PermeabilityIsATree) { check_published("permeability", 5, 0, 1.5); }
TEST(PublishedNetwork, SuperimposedHasFourRings) { check_published("superimposed", 5, 4, 1.5); }

TEST(Topology, ARingHasOneHandle) {
  std::vector<Vec3d> stations;
  std::vector<std::pair<int, int>> legs;
  for (int i = 0; i < 9; ++i) {
    stations.push_back({10 * std::cos(0.7 * i), i % 3 * 1.0, 10 * std::sin(0.7 * i)});
    legs.push_back({i, (i + 1) % 9});
  }
  expect_genus(with_radius(network_of(stations, legs), 1), 1, 0.25);
}

// A grid of m by n cells has m n handles; here with shafts to a second level.
TEST(Topology, AMazeHasAHandleForEachCell) {
  std::vector<Vec3d> stations;
  std::vector<std::pair<int, int>> legs;
  for (int level = 0; level < 2; ++level)
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 4; ++k) {
        const int here = static_cast<int>(stations.size());
        stations.push_back({12.0 * i + 0.5 * k, 10.0 * level + 0.3 * i * k, 11.0 * k});
        if (i > 0) legs.push_back({here - 4, here});
        if (k > 0) legs.push_back({here - 1, here});
        if (level > 0 && i == k) legs.push_back({here - 12, here});
      }
  const size_t cycles = legs.size() - stations.size() + 1;
  expect_genus(with_radius(network_of(stations, legs), 1.2), cycles, 0.3);
  PassageOptions options;  // Sections that were not measured, with chambers at all junctions.
  options.size = {2, 3, 0.3};
  options.meanders.sinuosity = 1.15;
  options.meanders.wavelength = 4;
  expect_genus(network_of(stations, legs), cycles, 0.25, options);
}

// Passages with a loop onto themselves, and two that cross without meeting.
TEST(Topology, LassosHaveOneHandle) {
  expect_genus(with_radius(network_of({{0, 0, 0}, {15, 0, 0}, {25, 0, 8}, {30, 0, 0}, {24, 2, -9}},
                                      {{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 1}}),
                           1),
               1, 0.25);
  const auto crossing = with_radius(
      network_of({{-10, 0, 0}, {10, 0, 0}, {0, 2.2, -10}, {0, 2.2, 10}}, {{0, 1}, {2, 3}}), 1);
  EXPECT_EQ(topology_of(passages(crossing), 0.05).components, 2u);
}

}  // namespace
}  // namespace vug::passages
