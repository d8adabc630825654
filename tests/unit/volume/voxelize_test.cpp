// SPDX-License-Identifier: Apache-2.0
// Direct evaluation: the level set is the field, clamped to the band, for any number of threads.
#include "solids.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

using field::Field;
using field::make;

double clamped(double value, double limit) { return std::max(-limit, std::min(limit, value)); }

void expect_clamped_field(const Field& field, double voxel, double tolerance) {
  VoxelizeOptions options;
  options.voxel = voxel;
  const LevelSet grid = voxelize(field, options);
  EXPECT_EQ(check(grid).fault, "");
  double worst = 0;
  each_lattice_point(grid, [&](const Vec3d& p, double value) {
    worst = std::max(worst, std::fabs(value - clamped(field.value(p), grid.background())));
  });
  EXPECT_LE(worst, tolerance * voxel);
}

// In voxels. Coordinates of up to 128 voxels, 64 in a brick and 64 of the solid, round to 7.6e-6, a
// norm doubles that, and so does the change of the sign of samples that are zero to within it.
constexpr double kRounding = 3e-5;

TEST(Voxelize, ExactPrimitivesKeepTheirDistances) {
  expect_clamped_field(make("sphere", {{"radius", 24.3 / 32}}), 1.0 / 32, kRounding);
  expect_clamped_field(make("torus", {{"radius", 0.5}, {"tube", 0.21}}), 1.0 / 32, kRounding);
  expect_clamped_field(make("box", {{"size", Vec3d(1.1, 0.8, 0.7)}}), 1.0 / 32, kRounding);
}

TEST(Voxelize, SharpBooleansKeepTheirValues) {
  const Field a = sphere_at({0.25, 0, 0}, 0.5), b = sphere_at({-0.25, 0.125, 0}, 0.4);
  for (const Field& f : {field::unite({a, b}), field::subtract(a, {b}), field::intersect({a, b}),
                         field::symmetric_difference(a, b)})
    expect_clamped_field(f, 1.0 / 32, kRounding);
}

TEST(Voxelize, AnyVoxelSizePassesTheChecks) {
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 30; ++i) {
    VoxelizeOptions options;
    options.voxel = random.uniform(0.03, 0.3);
    options.half_width = i % 2 ? 3 : random.uniform(3, 6);
    EXPECT_EQ(check(voxelize(lumpy_solid(), options)).fault, "") << options.voxel;
  }
}

TEST(Voxelize, ManySpheresEqualBruteForce) {
  RandomStream random(RandomKey(6));
  std::vector<Field> spheres;
  for (int i = 0; i < 300; ++i) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double z = random.uniform(-1, 1);
    spheres.push_back(sphere_at({x, y, z}, random.uniform(0.05, 0.2)));
  }
  expect_clamped_field(field::unite(spheres), 1.0 / 32, kRounding);
}

TEST(Voxelize, DeepInsideIsInside) {
  VoxelizeOptions options;
  options.voxel = 0.01;  // Radius of 1000 voxels: whole nodes lie inside.
  const Field shell = field::subtract(sphere_at({0, 0, 0}, 10), {sphere_at({0, 0, 0}, 9.9)});
  options.voxel = 0.05;
  const LevelSet grid = voxelize(shell, options);
  const LevelSet ball = voxelize(sphere_at({0, 0, 0}, 10), options);
  RandomStream random(RandomKey(7));
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-11, 11), y = random.uniform(-11, 11);
    const Vec3d p(x, y, random.uniform(-11, 11));
    const double distance = p.length() - 10;
    if (std::fabs(distance) < 0.05) continue;
    EXPECT_EQ(ball.value(p) < 0, distance < 0);
    if (distance < -0.3) {
      EXPECT_EQ(ball.value(p), -ball.background());
      EXPECT_EQ(grid.value(p), grid.background());
    }
  }
}

TEST(Voxelize, SameContentForAnyNumberOfThreads) {
  VoxelizeOptions options;
  options.voxel = 0.02;
  const Digest first = voxelize(lumpy_solid(), options).content();
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads,
                 [&] { EXPECT_EQ(voxelize(lumpy_solid(), options).content(), first) << threads; });
  }
  options.voxel = 0.021;
  EXPECT_NE(voxelize(lumpy_solid(), options).content(), first);
}

TEST(Voxelize, AnEmptyFieldGivesAnEmptyGrid) {
  const Field ball = sphere_at({0.3, 0, 0}, 0.5);
  for (const Field& f : {field::empty(), field::subtract(ball, {ball}),
                         field::intersect({ball, sphere_at({3, 0, 0}, 0.5)})}) {
    const LevelSet grid = voxelize(f, {});
    EXPECT_EQ(check(grid).fault, "");
    each_lattice_point(grid, [](const Vec3d&, double value) { EXPECT_GE(value, -1e-5); });
    EXPECT_FALSE(grid.holds_solid());
  }
  EXPECT_TRUE(voxelize(field::empty(), {}).empty());
  EXPECT_TRUE(voxelize(ball, {}).holds_solid());
}

TEST(Voxelize, ARegionCutsTheSolidWithFlatFaces) {
  VoxelizeOptions options;
  options.voxel = 1.0 / 16;
  options.region = Box3d({-0.5, -2, -2}, {0.25, 2, 2});
  const LevelSet grid = voxelize(make("sphere"), options);
  EXPECT_EQ(check(grid).fault, "");
  EXPECT_NEAR(grid.value({0.25, 0.125, 0}), 0, 1e-6);
  EXPECT_NEAR(grid.value({-0.5, 0.125, 0}), 0, 1e-6);
  EXPECT_NEAR(grid.value({0, 1, 0}), 0, 1e-6);
  EXPECT_GT(grid.value({0.75, 0, 0}), 0);
}

TEST(Voxelize, AnInfiniteSolidNeedsARegion) {
  const Field outside = field::complement(make("sphere", {{"radius", 0.5}}));
  try {
    voxelize(outside, {});
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::bad_input);
    EXPECT_NE(e.hint().find("region"), std::string::npos);
  }
  VoxelizeOptions options;
  options.region = Box3d(Vec3d(-1), Vec3d(1));
  const LevelSet grid = voxelize(outside, options);
  EXPECT_GT(grid.value({0, 0, 0}), 0);
  EXPECT_LT(grid.value({0.8, 0, 0}), 0);
}

TEST(Voxelize, RefusesInvalidArguments) {
  VoxelizeOptions options;
  for (const double voxel : {0.0, -1.0, std::nan(""), kInfinity}) {
    options.voxel = voxel;
    EXPECT_THROW(voxelize(make("sphere"), options), Error);
  }
  options.voxel = 1e-6;
  EXPECT_THROW(voxelize(make("sphere", {{"radius", 1e-5}}), options), Error);
  options = {};
  options.half_width = 2;
  EXPECT_THROW(voxelize(make("sphere"), options), Error);
}

TEST(Voxelize, LatticeBeyond32BitsIsRefused) {
  VoxelizeOptions options;
  options.voxel = 0.01;
  EXPECT_THROW(voxelize(sphere_at({1e8, 0, 0}, 1), options), Error);
}

TEST(Voxelize, StopsWhenCancelled) {
  Progress progress;
  progress.cancel();
  try {
    voxelize(make("sphere"), {}, progress);
    FAIL();
  } catch (const Error& e) {
    EXPECT_EQ(e.code(), ErrorCode::cancelled);
  }
}

TEST(Voxelize, StopsInTheMiddle) {
  Progress* handle = nullptr;
  Progress progress([&](const std::string&, double fraction) {
    if (fraction > 0.3) handle->cancel();
  });
  handle = &progress;
  VoxelizeOptions options;
  options.voxel = 0.01;
  EXPECT_THROW(voxelize(make("sphere"), options, progress), Error);
}

TEST(Voxelize, ReportsAllOfTheWork) {
  double last = 0;
  Progress progress([&](const std::string&, double fraction) { last = std::max(last, fraction); });
  voxelize(lumpy_solid(), {}, progress);
  EXPECT_EQ(last, 1);
}

}  // namespace
}  // namespace vug::volume
