// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/network.h>

#include <cmath>

namespace vug::network {
namespace {

Network fork() {
  Network network;
  for (const Vec3d& p : {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(2, 1, 0), Vec3d(2, -1, 0)})
    network.stations.push_back({.position = p});
  network.legs = {{.from = 0, .to = 1}, {.from = 1, .to = 2}, {.from = 3, .to = 1}};
  return network;
}

TEST(Network, ListsTheLegsOfEachStation) {
  Network network = fork();
  network.legs.push_back({.from = 0, .to = 0});
  const auto legs = legs_at_stations(network);
  EXPECT_EQ(legs[0], (std::vector<int>{0, 3, 3}));
  EXPECT_EQ(legs[1], (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(leg_vector(network, network.legs[2]), Vec3d(-1, 1, 0));
}

TEST(Network, RejectsInvalidContents) {
  EXPECT_NO_THROW(require_valid(fork()));
  Network network = fork();
  network.legs[1].to = 4;
  EXPECT_THROW(require_valid(network), Error);
  network = fork();
  network.stations[2].position.y = kInfinity;
  EXPECT_THROW(require_valid(network), Error);
  network = fork();
  network.stations[1].section = CrossSection{.left = -0.5};
  EXPECT_THROW(require_valid(network), Error);
  network.stations[1].section->left = 0;
  EXPECT_NO_THROW(require_valid(network));
  network.stations[0].splays.emplace_back(0, std::nan(""), 0);
  EXPECT_THROW(require_valid(network), Error);
}

}  // namespace
}  // namespace vug::network
