// SPDX-License-Identifier: Apache-2.0
#include "solids.h"

#include <vug/volume/density.h>
#include <vug/volume/fog.h>
#include <vug/volume/resampled.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

/// A ball of fog: a shell of increasing density around constant blocks.
Grid ball_grid() {
  VoxelizeOptions options;
  options.voxel = 0.05;
  return fog(voxelize(sphere_at({0, 0, 0}, 1), options));
}

TEST(Resampled, EveryVoxelHasItsValue) {
  const Grid where = ball_grid();
  const Grid made = resampled(where, [](const Vec3f& p) { return 2 + p.x + 10 * p.y; });
  EXPECT_EQ(made.grid_class(), GridClass::fog);
  EXPECT_EQ(made.statistics().active_voxels, where.statistics().active_voxels);
  EXPECT_EQ(made.voxel_size(), where.voxel_size());
  const Density values(made);
  // Trilinear lookups of a linear function are exact, also in the constant blocks.
  for (const Vec3f& p :
       {Vec3f(0.01f, 0.02f, 0.03f), Vec3f(0.5f, 0.31f, 0.2f), Vec3f(0, -0.1f, 0.7f)})
    EXPECT_NEAR(values.at_world(p), std::max(0.0f, 2 + p.x + 10 * p.y), 1e-4f);  // Of 65535 steps.
}

TEST(Resampled, VectorsWorkAndConstantBlocksAreTiles) {
  const Grid where = ball_grid();
  const Grid red = resampled_vectors(where, [](const Vec3f&) { return Vec3f(1, 0.5f, 0.25f); });
  EXPECT_EQ(red.value_type(), "vec3s");
  EXPECT_EQ(red.statistics().active_voxels, where.statistics().active_voxels);
  EXPECT_LE(red.statistics().leaves, where.statistics().leaves);
  EXPECT_EQ(Density(red, 2).at_world(Vec3f(0.0f)), 0.25f);
  EXPECT_EQ(Density(red, 2).at_world(Vec3f(3.0f)), 0);
}

}  // namespace
}  // namespace vug::volume
