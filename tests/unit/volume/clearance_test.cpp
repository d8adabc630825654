// SPDX-License-Identifier: Apache-2.0
// Two rooms of 3 m that a corridor joins: bodies pass exactly if they are narrower and lower than
// it.
#include <vug/base/error.h>
#include <vug/volume/clearance.h>

#include <gtest/gtest.h>

#include "solids.h"

namespace vug::volume {
namespace {

field::Field block(const Vec3d& size, const Vec3d& centre) {
  return field::transformed(field::make("box", {{"size", size}}), Transform::translation(centre));
}

/// The floors are at y = -1.5; the corridor is along x.
LevelSet rooms(double width, double height, double voxel) {
  const field::Field rock = field::subtract(
      block({10, 4, 5}, {0, 0, 0}), {block({3, 3, 3}, {-3, 0, 0}), block({3, 3, 3}, {3, 0, 0}),
                                     block({4, height, width}, {0, 0.5 * height - 1.5, 0})});
  VoxelizeOptions options;
  options.voxel = voxel;
  return voxelize(rock, options);
}

std::vector<int> regions(const LevelSet& rock, double diameter, double height) {
  ClearanceOptions options;
  options.body = {diameter, height};
  return free_regions(rock, {{-3, 0, 0}, {3, 0, 0}, {20, 0, 0}}, options);
}

bool passes(const LevelSet& rock, double diameter, double height) {
  const std::vector<int> found = regions(rock, diameter, height);
  return found[0] >= 0 && found[0] == found[1];
}

TEST(Clearance, BodiesPassIfTheyAreNarrowerThanTheCorridor) {
  const LevelSet rock = rooms(0.9, 2.4, 0.05);
  EXPECT_TRUE(passes(rock, 0.4, 1.8));
  EXPECT_TRUE(passes(rock, 0.65, 1.8));
  EXPECT_FALSE(passes(rock, 0.95, 1.8));
  EXPECT_FALSE(passes(rock, 1.5, 1.8));
  EXPECT_EQ(regions(rock, 1.5, 1.8)[0], 0) << "the first room has space for it";
}

TEST(Clearance, BodiesPassIfTheyAreLowerThanTheCorridor) {
  const LevelSet rock = rooms(1.5, 1.6, 0.05);
  EXPECT_TRUE(passes(rock, 0.4, 1.4));
  EXPECT_FALSE(passes(rock, 0.4, 1.8));
}

TEST(Clearance, DoesNotDependOnTheBandOfTheLevelSet) {
  // The band of 3 voxels ends far below the radius of the body.
  const LevelSet rock = rooms(1.5, 2.4, 0.05);
  EXPECT_LT(rock.background(), 0.3);
  EXPECT_TRUE(passes(rock, 1.1, 1.8));
  EXPECT_FALSE(passes(rock, 1.6, 1.8));
}

TEST(Clearance, PointsWithoutSpaceHaveNoRegion) {
  const LevelSet rock = rooms(0.9, 2.4, 0.1);
  EXPECT_EQ(regions(rock, 0.4, 1.8)[2], -1);
  EXPECT_EQ(regions(rock, 3.5, 3.5), (std::vector<int>{-1, -1, -1}));
}

TEST(Clearance, RefusesBodiesThatAreNoCapsules) {
  const LevelSet rock = rooms(0.9, 2.4, 0.1);
  for (const UprightCapsule& body :
       {UprightCapsule{0, 1.8}, UprightCapsule{2, 1.8}, UprightCapsule{0.4, kInfinity}}) {
    ClearanceOptions options;
    options.body = body;
    EXPECT_THROW(free_regions(rock, {{0, 0, 0}}, options), Error);
  }
  ClearanceOptions options;
  options.body = {0.01, 0.02};
  options.max_memory = 1 << 20;
  EXPECT_THROW(free_regions(rock, {{0, 0, 0}}, options), Error);
}

}  // namespace
}  // namespace vug::volume
