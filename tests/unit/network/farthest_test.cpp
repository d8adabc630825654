// SPDX-License-Identifier: Apache-2.0
#include <vug/network/farthest.h>

#include <gtest/gtest.h>

namespace vug::network {
namespace {

/// A ring of four stations with sides of 1, 1, 1 and 9 m, and one without legs.
Network ring() {
  Network out;
  for (const Vec3d& at : {Vec3d(0, 0, 0), Vec3d(1, 0, 0), Vec3d(2, 0, 0), Vec3d(3, 0, 0)})
    out.stations.push_back({.name = "s" + std::to_string(out.stations.size()), .position = at});
  out.stations[3].position = Vec3d(2, 9, 0);
  out.stations.push_back({.name = "alone", .position = Vec3d(99, 0, 0)});
  out.legs = {{.from = 0, .to = 1}, {.from = 2, .to = 1}, {.from = 2, .to = 3}};
  return out;
}

TEST(Farthest, BeginsAtTheEntrance) {
  Network cave = ring();
  EXPECT_EQ(first_station(cave), 0);
  cave.stations[2].flags.entrance = true;
  EXPECT_EQ(first_station(cave), 2);
  EXPECT_EQ(first_station({}), -1);
}

TEST(Farthest, IsTheEndOfTheLongestWay) {
  EXPECT_EQ(farthest_station(ring(), 0), 3);
  EXPECT_EQ(farthest_station(ring(), 3), 0);
  EXPECT_EQ(farthest_station(ring(), 4), 4) << "no legs";
  Network closed = ring();
  closed.stations[3].position = Vec3d(0, 0.5, 0);
  closed.legs.push_back({.from = 3, .to = 0});
  EXPECT_EQ(farthest_station(closed, 0), 2) << "over two sides of the ring";
}

}  // namespace
}  // namespace vug::network
