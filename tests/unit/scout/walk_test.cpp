// SPDX-License-Identifier: Apache-2.0
// Where a person can stand, in rooms whose floors are known.
#include "rooms.h"

#include <vug/scout/trace_view.h>
#include <vug/scout/walk.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

TEST(Walk, TheWholeFloorOfAHallIsReached) {
  const Room room(hall());
  const auto floor = walkable_floor(*room.location.world, {Vec3d(0.2, 3, 0.1)});
  // 23 x 5 points of the grid are at least the body's 0.25 m from the walls.
  EXPECT_EQ(floor.size(), 23u * 5);
  for (const Stand& each : floor) {
    EXPECT_NEAR(each.floor.y, 0, 0.02);
    EXPECT_NEAR(each.headroom, 5, 0.04);
    EXPECT_LT(std::fabs(each.floor.x), 11.8);
    EXPECT_LT(std::fabs(each.floor.z), 2.8);
  }
}

TEST(Walk, AWallAHighStepAndALowCeilingEndTheWay) {
  const auto reached = [](const std::string& rock) {
    const Room room(hall("", rock));
    const auto floor = walkable_floor(*room.location.world, {Vec3d(-8, 3, 0)});
    return std::any_of(floor.begin(), floor.end(),
                       [](const Stand& each) { return each.floor.x > 6; });
  };
  EXPECT_TRUE(reached(""));
  EXPECT_FALSE(reached(" + box(size: (2, 10, 8)).translate((3, 3, 0))")) << "a wall";
  EXPECT_FALSE(reached(" + box(size: (20, 3, 8)).translate((12, 0, 0))")) << "a step of 1.5 m";
  EXPECT_TRUE(reached(" + box(size: (20, 1.5, 8)).translate((12, 0, 0))")) << "a step of 0.75 m";
  EXPECT_FALSE(reached(" + box(size: (4, 5, 8)).translate((3, 3.2, 0))")) << "0.7 m of headroom";
  EXPECT_TRUE(reached(" + box(size: (4, 5, 8)).translate((3, 3.8, 0))")) << "1.3 m of headroom";
}

TEST(Walk, TheClearanceIsTheDistanceToTheNearestWallAndZeroInRock) {
  const Room room(hall());
  EXPECT_NEAR(clearance(*room.location.world, {0, 2, 0}), 2, 0.02);
  EXPECT_NEAR(clearance(*room.location.world, {0, 2.5, 2.4}), 0.6, 0.02);
  EXPECT_EQ(clearance(*room.location.world, {0, 2.5, 8}), 0);
  EXPECT_EQ(clearance(*room.location.world, {0, 30, 0}), 22)
      << "above the block, only the ray down";
  const auto floor = floor_below(*room.location.world, {1, 4, 0}, 10);
  ASSERT_TRUE(floor);
  EXPECT_NEAR(floor->y, 0, 0.02);
  EXPECT_FALSE(floor_below(*room.location.world, {1, 4, 0}, 3));
}

TEST(Walk, WithoutACameraTheAirOfTheRockIsFound) {
  const Room room(hall());
  EXPECT_TRUE(room.location.starts.empty());
  const auto floor = places_to_stand(room.location);
  EXPECT_EQ(floor.size(), 23u * 5) << "the roof of the block has no ceiling";
}

TEST(Walk, AHangingBodyHasNoFloor) {
  const Room room(
      "volume ball = level_set(sphere(1m), voxel: 20cm)\n"
      "camera main { eye (4, 0, 0) }\n");
  try {
    const auto floor = places_to_stand(room.location);
    // The top of the ball is level: a few places, and nothing else.
    for (const Stand& each : floor) EXPECT_LT(each.floor.length(), 1.1);
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
  }
}

}  // namespace
}  // namespace vug::scout
