// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/registry.h>
#include <vug/volume/converted.h>
#include <vug/volume/fog.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

LevelSet moved_ball() {
  VoxelizeOptions options;
  options.voxel = 0.1;
  const field::Field at_origin = field::make("sphere", {{"radius", 1.0}});
  return voxelize(field::transformed(at_origin, Transform::translation({1, 2, 3})), options);
}

const Transform kToCentimetresAndZUp(Vec3d(100, 0, 0), Vec3d(0, 0, 100), Vec3d(0, -100, 0),
                                     Vec3d(0, 0, 0));

TEST(Converted, DistancesAndPositionsScale) {
  const LevelSet here = moved_ball();
  const LevelSet there(converted(here, kToCentimetresAndZUp));
  EXPECT_TRUE(check(there).good()) << check(there).fault;
  EXPECT_NEAR(there.voxel(), 10, 1e-9);
  EXPECT_NEAR(there.background(), 100 * here.background(), 1e-4);
  EXPECT_EQ(there.statistics().active_voxels, here.statistics().active_voxels);
  // (1, 2, 3) with y up is (1, -3, 2) with z up.
  for (const Vec3d& at : {Vec3d(1, 2.95, 3), Vec3d(1, 3.1, 3), Vec3d(1.9, 2, 3), Vec3d(1, 2, 2.2)})
    EXPECT_NEAR(there.value(kToCentimetresAndZUp.point(at)), 100 * here.value(at), 1e-3);
  EXPECT_LT(there.value({100, -300, 200}), 0);
  // The background scales as well.
  EXPECT_NEAR(there.value({1e5, 0, 0}), there.background(), 1e-9);
}

TEST(Converted, FogKeepsItsDensityAndTheOriginalIsUnchanged) {
  const LevelSet here = moved_ball();
  const Grid before = fog(here);
  const Digest content = before.content();
  const Grid there = converted(before, kToCentimetresAndZUp);
  EXPECT_EQ(there.grid_class(), GridClass::fog);
  EXPECT_EQ(there.statistics().active_voxels, before.statistics().active_voxels);
  const Box3d box = kToCentimetresAndZUp.box(before.statistics().bounds);
  EXPECT_LT((there.statistics().bounds.max - box.max).length(), 1e-6);
  EXPECT_EQ(before.content(), content);
}

}  // namespace
}  // namespace vug::volume
