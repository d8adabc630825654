// SPDX-License-Identifier: Apache-2.0
// Passages above a slope.
#include <vug/terrain/exits.h>

#include <gtest/gtest.h>

namespace vug::terrain {
namespace {

/// Ground whose height is x / 2, from x = -100 to 100.
field::Ground slope() {
  const std::vector<float> heights = {-50, 50, -50, 50};
  return {field::Heightmap(2, 2, heights, 200, 200, field::Sampling::bilinear), Vec3d(0),
          Vec3d(200, 0, 200), 100};
}

network::Network passage(double height) {
  network::Network out;
  out.stations = {{.name = "mouth", .position = {0, 0, 0}, .flags = {.entrance = true}},
                  {.name = "bend", .position = {40, 0, 0}},
                  {.name = "end", .position = {40, height, 30}}};
  out.legs = {{.from = 0, .to = 1}, {.from = 1, .to = 2}};
  return out;
}

TEST(PassagesAboveGround, APassageUnderTheGroundHasNone) {
  EXPECT_TRUE(exits(passage(10), slope(), 0.5).empty());
}

TEST(PassagesAboveGround, NameTheHighestRoofAndItsStation) {
  network::Network cave = passage(26);
  std::vector<Exit> found = exits(cave, slope(), 0.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].station, "end");
  EXPECT_NEAR(found[0].height, 6, 1e-9);
  EXPECT_NEAR((found[0].position - cave.stations[2].position).length(), 0, 1e-9);
  cave.stations[2].section = network::CrossSection{.up = 3};
  EXPECT_NEAR(exits(cave, slope(), 0.5)[0].height, 9, 1e-9);
  cave.legs[1].surface = true;
  EXPECT_TRUE(exits(cave, slope(), 0.5).empty());
}

TEST(PassagesAboveGround, EntrancesAndEndsWithoutFlagsAreOpenings) {
  network::Network cave = passage(26);
  cave.stations[2].flags.spring = true;
  // The leg rises above the ground for 7 m before its end.
  EXPECT_TRUE(exits(cave, slope(), 0.5).empty());
  cave.stations[2].flags.spring = cave.stations[0].flags.entrance = false;
  EXPECT_TRUE(exits(cave, slope(), 0.5).empty());
}

TEST(PassagesAboveGround, SeparatePlacesAreSeparateAndTheHighestIsFirst) {
  network::Network cave = passage(10);
  cave.stations.push_back({.name = "a", .position = {-60, 2, 0}});
  cave.stations.push_back({.name = "b", .position = {-60, 2, 40}});
  cave.stations.push_back({.name = "c", .position = {-20, 2, 60}});
  cave.stations.push_back({.name = "d", .position = {-20, 2, 80}});
  cave.legs.push_back({.from = 5, .to = 6});
  cave.legs.push_back({.from = 3, .to = 4});
  const std::vector<Exit> found = exits(cave, slope(), 0.5);
  ASSERT_EQ(found.size(), 2u);
  EXPECT_NEAR(found[0].height, 32, 1e-9);
  EXPECT_NEAR(found[1].height, 12, 1e-9);
}

}  // namespace
}  // namespace vug::terrain
