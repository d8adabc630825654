// SPDX-License-Identifier: Apache-2.0
// Products of level sets: fog volumes, samples, polygons, statistics.
#include "solids.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/volume/fog.h>
#include <vug/volume/polygons.h>

#include <gtest/gtest.h>

#include <map>

namespace vug::volume {
namespace {

LevelSet product_ball(double voxel) {
  VoxelizeOptions options;
  options.voxel = voxel;
  return voxelize(sphere_at({0.1, 0.2, 0.3}, 1), options);
}

TEST(Grid, StatisticsOfABall) {
  const LevelSet grid = product_ball(0.05);
  const Statistics s = grid.statistics();
  // Shell of +-3 voxels about radius 20: 4/3 pi (23^3 - 17^3) lattice points.
  const double expected = 4.0 / 3 * kPi * (23.0 * 23 * 23 - 17 * 17 * 17);
  EXPECT_NEAR(static_cast<double>(s.active_voxels), expected, 0.01 * expected);
  EXPECT_GT(s.leaves, 0u);
  EXPECT_GE(s.memory_bytes, s.leaves * 2048);
  for (int axis = 0; axis < 3; ++axis) {
    const double centre = 0.1 * (axis + 1);
    EXPECT_NEAR(s.bounds.min[axis], centre - 1.15, 0.051);
    EXPECT_NEAR(s.bounds.max[axis], centre + 1.15, 0.051);
  }
  EXPECT_EQ(grid.value_type(), "float");
  EXPECT_EQ(grid.grid_class(), GridClass::level_set);
}

TEST(Grid, NamesAndMetadataDoNotChangeTheContent) {
  const LevelSet grid = product_ball(0.1);
  const Grid other = grid.named("rock").with({{"vug:seed", int64_t{7}}});
  EXPECT_EQ(other.name(), "rock");
  EXPECT_EQ(grid.name(), "");
  EXPECT_EQ(std::get<int64_t>(other.metadata().at("vug:seed")), 7);
  EXPECT_EQ(grid.metadata().count("vug:seed"), 0u);
  EXPECT_EQ(other.content(), grid.content());
}

TEST(LevelSet, SamplesLinearlyBetweenVoxels) {
  const LevelSet grid = product_ball(0.05);
  const double a = grid.value({1.10, 0.2, 0.3}), b = grid.value({1.15, 0.2, 0.3});
  EXPECT_NEAR(grid.value({1.125, 0.2, 0.3}), 0.5 * (a + b), 1e-7);
  EXPECT_NEAR(a, 0, 1e-6);
}

TEST(LevelSet, RefusesOtherGrids) {
  const Grid density = fog(product_ball(0.1));
  EXPECT_THROW(LevelSet{density}, Error);
}

TEST(Fog, DensityRisesFromTheSurfaceInwards) {
  const LevelSet grid = product_ball(0.05);
  const Grid density = fog(grid);
  EXPECT_EQ(density.grid_class(), GridClass::fog);
  const Statistics s = density.statistics();
  const double volume = 4.0 / 3 * kPi * 20 * 20 * 20;
  EXPECT_NEAR(static_cast<double>(s.active_voxels), volume, 0.02 * volume);
  EXPECT_NE(density.content(), fog(grid, {.falloff = 0.05}).content());
  EXPECT_EQ(grid.content(), product_ball(0.05).content());  // The source is unchanged.
}

TEST(Polygons, BallIsClosedAndWoundOutwards) {
  const Polygons mesh = polygons_of(product_ball(0.05));
  double volume = 0;
  std::map<std::pair<uint32_t, uint32_t>, int> edges;
  auto corner = [&](uint32_t i) { return Vec3d(mesh.points[i]); };
  auto triangle = [&](uint32_t a, uint32_t b, uint32_t c) {
    volume += corner(a).dot(corner(b).cross(corner(c))) / 6;
  };
  for (const auto& q : mesh.quads) {
    triangle(q[0], q[1], q[2]);
    triangle(q[0], q[2], q[3]);
    for (size_t k = 0; k < 4; ++k) ++edges[{q[k], q[(k + 1) % 4]}];
  }
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_NEAR(volume, 4.0 / 3 * kPi, 0.01 * 4.0 / 3 * kPi);  // Positive: oriented outwards.
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_EQ((edges.count({edge.second, edge.first})), 1u);
  }
}

TEST(Polygons, SameForAnyNumberOfThreads) {
  VoxelizeOptions options;
  options.voxel = 0.02;
  const LevelSet grid = voxelize(lumpy_solid(), options);
  const Polygons first = polygons_of(grid, {.adaptivity = 0.3});
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const Polygons again = polygons_of(grid, {.adaptivity = 0.3});
      EXPECT_EQ(again.points, first.points);
      EXPECT_EQ(again.quads, first.quads);
      EXPECT_EQ(again.triangles, first.triangles);
    });
  }
}

}  // namespace
}  // namespace vug::volume
