// SPDX-License-Identifier: Apache-2.0
// A voxel has the same value in every tile that contains it, whatever the size, the position and
// the order of the tiles.
#include "solids.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/displace.h>
#include <vug/volume/bricks.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::volume {
namespace {

using field::Field;

/// Steep and blended values, thin and wide parts, and a large inside.
Field solid() {
  const Field rough =
      field::displaced(field::transformed(lumpy_solid(), Transform::translation({1.3, -0.4, 0.7})),
                       field::make_noise("fbm", {{"scale", 0.6}}), field::Displacement());
  std::vector<Field> parts = {rough, sphere_at({-0.9, 0.3, 0.2}, 1.2)};
  RandomStream random(RandomKey(4));
  for (int i = 0; i < 60; ++i) {
    const double x = random.uniform(-2, 2), y = random.uniform(-2, 2), z = random.uniform(-2, 2);
    parts.push_back(sphere_at({x, y, z}, random.uniform(0.01, 0.1)));
  }
  return field::unite(std::move(parts));
}

int floor_to(int value, int step) {
  return static_cast<int>(std::floor(static_cast<double>(value) / step)) * step;
}

/// All tiles of an edge with a boundary at `offset` that contain a part of the level set.
std::vector<LatticeBox> tiles_of(const LevelSet& whole, int edge, int offset) {
  const Statistics s = whole.statistics();
  std::vector<LatticeBox> out;
  Vec3i first;
  for (int axis = 0; axis < 3; ++axis)
    first[axis] = floor_to(s.index_min[axis] - offset, edge) + offset;
  for (int x = first.x; x <= s.index_max.x; x += edge)
    for (int y = first.y; y <= s.index_max.y; y += edge)
      for (int z = first.z; z <= s.index_max.z; z += edge)
        out.push_back({Vec3i(x, y, z), Vec3i(x + edge - 1, y + edge - 1, z + edge - 1)});
  return out;
}

LevelSet tiled(const Field& field, VoxelizeOptions options, const std::vector<LatticeBox>& tiles) {
  std::vector<LevelSet> parts;
  for (const LatticeBox& tile : tiles) {
    options.tile = tile;
    parts.push_back(voxelize(field, options));
  }
  return joined(parts);
}

TEST(Tiles, OfAnySizeAndPositionEqualTheWhole) {
  const VoxelizeOptions options = with_voxel(0.017);
  const LevelSet whole = voxelize(solid(), options);
  const auto expected = brick_digests(whole);
  ASSERT_GT(expected.size(), 8u);
  for (const auto& [edge, offset] : {std::pair(128, 0), {256, 0}, {1024, 0}, {136, 8}, {256, 200}})
    EXPECT_EQ(brick_digests(tiled(solid(), options, tiles_of(whole, edge, offset))), expected)
        << edge << " from " << offset;
}

TEST(Tiles, DoNotDependOnTheirOrderAndOnThreads) {
  const VoxelizeOptions options = with_voxel(0.017);
  const LevelSet whole = voxelize(solid(), options);
  const auto expected = brick_digests(whole);
  std::vector<LatticeBox> tiles = tiles_of(whole, 128, 64);
  RandomStream random(RandomKey(8));
  for (const int threads : {1, 2, 7}) {
    for (size_t i = tiles.size(); i > 1; --i)
      std::swap(tiles[i - 1], tiles[random.below(static_cast<uint32_t>(i))]);
    with_threads(threads, [&] {
      EXPECT_EQ(brick_digests(tiled(solid(), options, tiles)), expected) << threads;
    });
  }
}

TEST(Tiles, OfWideBandsEqualTheWhole) {
  VoxelizeOptions options = with_voxel(0.02);
  options.half_width = 9.5;
  const LevelSet whole = voxelize(lumpy_solid(), options);
  EXPECT_EQ(brick_digests(tiled(lumpy_solid(), options, tiles_of(whole, 64, 8))),
            brick_digests(whole));
}

TEST(Tiles, WithoutASurfaceAreInsideOrOutside) {
  const VoxelizeOptions options = with_voxel(0.1);
  const Field ball = sphere_at({0, 0, 0}, 10);
  const LevelSet whole = voxelize(ball, options);
  EXPECT_EQ(brick_digests(tiled(ball, options, tiles_of(whole, 24, 8))), brick_digests(whole));
}

// The surface crosses the face of a tile for one voxel only.
TEST(Tiles, KeepSliversOnTheirFaces) {
  const VoxelizeOptions options = with_voxel(1.0 / 64);
  for (const double beyond : {0.0, 0.2, 0.5, 1.0, 1.7}) {
    const double radius = 0.5;
    const Field ball = sphere_at({2 - radius + beyond * options.voxel, 0.7, 0.7}, radius);
    const LevelSet whole = voxelize(ball, options);
    const LevelSet parts = tiled(ball, options, tiles_of(whole, 128, 0));
    EXPECT_EQ(brick_digests(parts), brick_digests(whole)) << beyond;
    EXPECT_EQ(parts.statistics().active_voxels, whole.statistics().active_voxels) << beyond;
  }
}

TEST(Tiles, OutsideTheirBoxAreEmpty) {
  VoxelizeOptions options = with_voxel(1.0 / 32);
  options.tile = LatticeBox(Vec3i(-8, 0, 8), Vec3i(15, 31, 23));
  const LevelSet tile = voxelize(sphere_at({0, 0.5, 0.5}, 0.4), options);
  EXPECT_EQ(check(tile).fault, "");
  const Statistics s = tile.statistics();
  ASSERT_GT(s.active_voxels, 0u);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_GE(s.index_min[axis], options.tile->min[axis]);
    EXPECT_LE(s.index_max[axis], options.tile->max[axis]);
  }
}

TEST(Tiles, ConsistOfWholeBlocks) {
  VoxelizeOptions options = with_voxel(0.1);
  options.tile = LatticeBox(Vec3i(0), Vec3i(16));
  EXPECT_THROW(voxelize(lumpy_solid(), options), Error);
}

TEST(Bricks, HaveDigestsThatDependOnTheirContentAlone) {
  // Dyadic voxels, so that moved coordinates are exact.
  const VoxelizeOptions options = with_voxel(1.0 / 64);
  const auto digests = [&](const Vec3d& at) {
    return brick_digests(voxelize(sphere_at(at, 0.5), options));
  };
  const auto here = digests({1, 1, 1}), moved = digests({3, 1, 1}), other = digests({1, 1, 1.001});
  ASSERT_EQ(here.size(), 1u);
  EXPECT_EQ(here.begin()->second, moved.begin()->second);
  EXPECT_NE(here.begin()->first, moved.begin()->first);
  EXPECT_NE(here.begin()->second, other.begin()->second);
  EXPECT_TRUE(brick_digests(voxelize(field::empty(), options)).empty());
}

TEST(Bricks, WhollyInsideArePresent) {
  const auto found = brick_digests(voxelize(sphere_at({0, 0, 0}, 10), with_voxel(0.025)));
  // Bricks have an edge of 3.2 m, and those in the middle are farther than the band from the
  // surface.
  EXPECT_EQ(found.count({0, 0, 0}), 1u);
  EXPECT_EQ(found.at({0, 0, 0}), found.at({-128, -128, -128}));
}

TEST(Bricks, JoinOnlyTilesOfOneLattice) {
  EXPECT_THROW(joined({}), Error);
  EXPECT_THROW(
      joined({voxelize(lumpy_solid(), with_voxel(0.1)), voxelize(lumpy_solid(), with_voxel(0.2))}),
      Error);
}

}  // namespace
}  // namespace vug::volume
