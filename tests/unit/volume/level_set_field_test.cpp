// SPDX-License-Identifier: Apache-2.0
// A level set as a field: in its band it equals the original field.
#include "solids.h"

#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/volume/io.h>
#include <vug/volume/level_set_field.h>

#include <gtest/gtest.h>

#include <filesystem>

#include <fmt/format.h>

namespace vug::volume {
namespace {

TEST(LevelSetField, FollowsTheFieldInTheBand) {
  VoxelizeOptions options;
  options.voxel = 1.0 / 32;
  const field::Field ball = sphere_at({0.1, 0.2, 0.3}, 0.8);
  const LevelSet grid = voxelize(ball, options);
  const auto read = sampled_grid(grid);
  RandomStream random(RandomKey(12));
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const Vec3d p = Vec3d(0.1, 0.2, 0.3) + Vec3d(x, y, random.uniform(-1, 1));
    const field::Gradient sampled = read->sample(p);
    EXPECT_NEAR(sampled.value, grid.value(p),
                1e-7 * grid.background());  // It samples in single precision.
    const field::Gradient exact = ball.gradient(p);
    if (std::fabs(exact.value) > 1.5 * options.voxel) continue;
    // Curvature 1/r bends a cell by 3 h^2 / 8 r, and rotates the gradient by sqrt(3) h / r.
    EXPECT_NEAR(sampled.value, exact.value, 3 * options.voxel * options.voxel / (8 * 0.75));
    EXPECT_LT((sampled.gradient - exact.gradient).length(), 1.8 * options.voxel / 0.75);
  }
  EXPECT_GE(read->lipschitz(), 1);
  EXPECT_LE(read->lipschitz(), std::sqrt(3.0) + 1e-3);
  EXPECT_DOUBLE_EQ(read->band(), grid.background());
}

TEST(LevelSetField, AFileBecomesASolidAgain) {
  VoxelizeOptions options;
  options.voxel = 1.0 / 16;
  const ScratchFolder scratch("vug_samples");
  const std::string file = scratch.file("rock.vdb").string();
  // Smooth, because the slope of one cell at a crease is unrelated to the distance.
  const field::Field soft = field::unite(
      {sphere_at({0.4, 0, 0}, 0.6), sphere_at({-0.3, 0.2, 0}, 0.5)}, {field::Profile::smooth, 0.5});
  const LevelSet first = voxelize(soft, options);
  write(file, {first.named("rock")});
  install_grid_loader();
  const field::Field solid = field::sampled(field::load_grid(file, "rock"));
  const LevelSet again = voxelize(solid, options);
  EXPECT_EQ(check(again).fault, "");
  double worst = 0;
  each_lattice_point(first, [&](const Vec3d& p, double value) {
    if (std::fabs(value) > options.voxel) return;
    const double repeated = again.value(p);
    worst = std::max(worst, std::fabs(repeated - value) + ((repeated < 0) == (value < 0) ? 0 : 1));
  });
  EXPECT_LT(worst, 0.3 * options.voxel);
}

}  // namespace
}  // namespace vug::volume
