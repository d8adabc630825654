// SPDX-License-Identifier: Apache-2.0
// The cost is estimated before the work starts, with sufficient accuracy for planning.
#include "solids.h"

#include <vug/base/error.h>
#include <vug/base/memory.h>
#include <vug/base/rng.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

using field::Field;
using field::make;

TEST(Estimate, AreaOfASphere) {
  VoxelizeOptions options;
  options.voxel = 0.002;
  const VoxelizeEstimate e = estimate(make("sphere"), options);
  EXPECT_NEAR(e.surface_area, 4 * kPi, 0.05 * 4 * kPi);
}

TEST(Estimate, CountsMatchTheResult) {
  RandomStream random(RandomKey(8));
  std::vector<Field> spheres;
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    spheres.push_back(sphere_at({x, y, random.uniform(-1, 1)}, random.uniform(0.1, 0.3)));
  }
  for (const Field& f : {make("sphere"), lumpy_solid(), field::unite(spheres),
                         field::morph(spheres[0], field::unite(spheres), 0.3)}) {
    VoxelizeOptions options;
    options.voxel = 0.02;
    const VoxelizeEstimate e = estimate(f, options);
    const Statistics s = voxelize(f, options).statistics();
    const auto active = static_cast<double>(s.active_voxels);
    EXPECT_NEAR(e.active_voxels, active, 0.2 * active);
    const auto leaves = static_cast<double>(s.leaves);
    EXPECT_NEAR(e.leaves, leaves, 0.25 * leaves);
    // Never much less than the size of the grid, and not excessively more.
    const auto bytes = static_cast<double>(s.memory_bytes);
    EXPECT_GT(e.bytes, 0.9 * bytes);
    EXPECT_LT(e.bytes, 1.6 * bytes + 1e7);
  }
}

TEST(Estimate, ANanometreIsRefusedImmediately) {
  VoxelizeOptions options;
  options.voxel = 1e-9;
  options.max_memory = uint64_t{8} << 30;
  const VoxelizeEstimate e = estimate(make("sphere"), options);
  // 4 pi r^2 / (8 voxel)^2 surface blocks, each met by a slab 15 to 20 voxels thick.
  EXPECT_GT(e.bytes, 1e20);
  EXPECT_LT(e.bytes, 1e22);
  for (const Field& f : {make("sphere"), lumpy_solid(), sphere_at({1e6, 0, 0}, 10)}) try {
      voxelize(f, options);
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::too_large);
      EXPECT_NE(std::string(error.what()).find("TiB"), std::string::npos) << error.what();
    }
}

TEST(Estimate, AModestLimitIsRespected) {
  VoxelizeOptions options;
  options.voxel = 0.005;
  options.max_memory = 10 << 20;
  EXPECT_THROW(voxelize(make("sphere"), options), Error);
  options.max_memory = uint64_t{1} << 30;
  EXPECT_NO_THROW(voxelize(make("sphere"), options));
}

}  // namespace
}  // namespace vug::volume
