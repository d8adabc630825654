// SPDX-License-Identifier: Apache-2.0
// A rock whose blocks are edited one after another has the bytes of a rock that is made from
// scratch, and only the voxels near the edited block are evaluated.
#include "solids.h"

#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/displace.h>
#include <vug/volume/bricks.h>
#include <vug/volume/voxel_cache.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace vug::volume {
namespace {

using field::Field;

constexpr double kRockVoxel = 0.05;

struct RockBlock {
  Vec3d at{0.0};
  double turn = 0;

  Field field() const {
    return field::transformed(field::make("box", {{"size", Vec3d(0.7, 0.5, 0.6)}}),
                              Transform::translation(at) * Transform::rotation({1, 2, 0.5}, turn));
  }
  /// Around the block in any orientation.
  Box3d bounds() const { return {at - Vec3d(0.55), at + Vec3d(0.55)}; }
};

/// Blocks on rough ground.
struct Rock {
  explicit Rock(uint64_t seed) : random(RandomKey(seed)) {
    for (int i = 0; i < 12; ++i) blocks.push_back(new_block());
  }
  RockBlock new_block() {
    const double x = random.uniform(-4, 4), y = random.uniform(0, 0.5), z = random.uniform(-4, 4);
    return {{x, y, z}, random.uniform(0, 3)};
  }
  /// Moves a random block. Returns it as it was and as it is.
  std::pair<RockBlock, RockBlock> edit() {
    RockBlock& block = blocks[random.below(static_cast<uint32_t>(blocks.size()))];
    const RockBlock before = block;
    block = new_block();
    return {before, block};
  }
  Field field() const {
    std::vector<Field> parts;
    for (const RockBlock& block : blocks) parts.push_back(block.field());
    const Field ground =
        field::displaced(field::make("box", {{"size", Vec3d(10, 1, 10)}}),
                         field::make_noise("fbm", {{"scale", 0.8}}), field::Displacement());
    return field::unite({ground, field::unite(std::move(parts))}, {field::Profile::smooth, 0.05});
  }

  RandomStream random;
  std::vector<RockBlock> blocks;
};

BlockCounts difference(const BlockCounts& now, const BlockCounts& before) {
  return {now.evaluated - before.evaluated, now.reused - before.reused};
}

/// The number of blocks of voxels near the surface whose expression can contain one of the boxes:
/// the box is below the largest value of the rock in the block's ball.
size_t blocks_near(const std::vector<Box3d>& boxes, double slope) {
  constexpr double kEdge = 8 * kRockVoxel, kBlend = 0.05;
  const double radius = 3.5 * std::sqrt(3.0) * kRockVoxel, band = 3 * kRockVoxel;
  const double reach = radius + slope * (2 * radius + 1.01 * band) + 2 * kBlend;
  size_t near = 0;
  for (int x = -20; x < 20; ++x)
    for (int y = -20; y < 20; ++y)
      for (int z = -20; z < 20; ++z) {
        const Vec3d centre = Vec3d(x + 0.5, y + 0.5, z + 0.5) * kEdge;
        near += std::any_of(boxes.begin(), boxes.end(), [&](const Box3d& box) {
          Vec3d nearest = centre;
          for (int axis = 0; axis < 3; ++axis)
            nearest[axis] = std::clamp(centre[axis], box.min[axis], box.max[axis]);
          return (nearest - centre).length() < reach;
        });
      }
  return near;
}

TEST(VoxelCaches, EditsEqualANewBuild) {
  const VoxelizeOptions options = with_voxel(kRockVoxel);
  Rock rock(3);
  VoxelCache cache;
  const LevelSet first = voxelize(rock.field(), options, cache);
  EXPECT_EQ(first.content(), voxelize(rock.field(), options).content());
  const uint64_t all = cache.counts().evaluated;
  EXPECT_EQ(cache.counts().reused, 0u);
  EXPECT_GT(all, 1000u);
  for (int i = 0; i < 5; ++i) {
    const auto [before, after] = rock.edit();
    const BlockCounts last = cache.counts();
    const LevelSet edited = voxelize(rock.field(), options, cache);
    const BlockCounts edit = difference(cache.counts(), last);
    EXPECT_EQ(edited.content(), voxelize(rock.field(), options).content()) << i;
    VoxelCache fresh;
    voxelize(rock.field(), options, fresh);
    EXPECT_EQ(edit.evaluated + edit.reused, fresh.counts().evaluated) << i;
    EXPECT_GE(edit.evaluated, 1u) << i;
    EXPECT_LE(edit.evaluated,
              blocks_near({before.bounds(), after.bounds()}, rock.field().lipschitz()))
        << i;
    EXPECT_GT(edit.reused, edit.evaluated) << i;
  }
  // Nothing is evaluated if nothing changes, as after the undo of an edit.
  const BlockCounts last = cache.counts();
  voxelize(rock.field(), options, cache);
  EXPECT_EQ(difference(cache.counts(), last).evaluated, 0u);
}

TEST(VoxelCaches, DoNotDependOnThreads) {
  const VoxelizeOptions options = with_voxel(kRockVoxel);
  std::optional<BlockCounts> expected;
  for (const int threads : {1, 2, 7})
    with_threads(threads, [&] {
      Rock rock(5);
      VoxelCache cache;
      voxelize(rock.field(), options, cache);
      for (int i = 0; i < 3; ++i) {
        rock.edit();
        EXPECT_EQ(voxelize(rock.field(), options, cache).content(),
                  voxelize(rock.field(), options).content())
            << threads << " threads, edit " << i;
      }
      if (!expected) expected = cache.counts();
      EXPECT_EQ(cache.counts().evaluated, expected->evaluated) << threads;
      EXPECT_EQ(cache.counts().reused, expected->reused) << threads;
    });
}

TEST(VoxelCaches, DistinguishSettings) {
  const Rock rock(7);
  VoxelCache cache;
  VoxelizeOptions options = with_voxel(kRockVoxel);
  voxelize(rock.field(), options, cache);
  const auto check = [&](const char* what) {
    const BlockCounts before = cache.counts();
    EXPECT_EQ(voxelize(rock.field(), options, cache).content(),
              voxelize(rock.field(), options).content())
        << what;
    return difference(cache.counts(), before);
  };
  options.half_width = 4;
  EXPECT_EQ(check("band").reused, 0u);
  options.repair = false;
  EXPECT_EQ(check("repair").reused, 0u);
  options.voxel = 0.06;
  EXPECT_EQ(check("voxel").reused, 0u);
  options = with_voxel(kRockVoxel);
  options.region = Box3d(Vec3d(-3.1, -1, -3.3), Vec3d(2.9, 2, 3.7));
  check("region");
  options.region.reset();
  options.tile = LatticeBox(Vec3i(-24, -16, 8), Vec3i(47, 31, 63));
  const BlockCounts tile = check("tile");
  EXPECT_GT(tile.reused, 0u);
  EXPECT_EQ(tile.evaluated, 0u);  // They are blocks of the whole.
}

// Faces on the lattice: which values count as zero depends on all parts of a brick.
TEST(VoxelCaches, KeepContacts) {
  const VoxelizeOptions options = with_voxel(0.0625);
  const auto solid = [](double far) {
    const auto box = [](const Vec3d& at, double turn) {
      return field::transformed(field::make("box", {{"size", Vec3d(1, 1, 1)}}),
                                Transform::translation(at) * Transform::rotation({0, 1, 0}, turn));
    };
    return field::unite({box({1, 1, 1}, 0), box({2, 1, 1}, 0), box({6, 1.03, 1}, far)});
  };
  VoxelCache cache;
  voxelize(solid(0.1), options, cache);
  for (const double turn : {0.5, 1.1, 0.7}) {
    const BlockCounts before = cache.counts();
    EXPECT_EQ(voxelize(solid(turn), options, cache).content(),
              voxelize(solid(turn), options).content())
        << turn;
    EXPECT_GT(difference(cache.counts(), before).reused, 0u) << turn;
  }
}

TEST(VoxelCaches, OfAnySizeGiveTheSameVoxels) {
  const VoxelizeOptions options = with_voxel(kRockVoxel);
  for (const uint64_t bytes : {uint64_t{0}, uint64_t{300000}}) {
    Rock rock(9);
    VoxelCache cache(bytes);
    for (int i = 0; i < 3; ++i) {
      EXPECT_EQ(voxelize(rock.field(), options, cache).content(),
                voxelize(rock.field(), options).content())
          << bytes << " bytes, edit " << i;
      EXPECT_LE(cache.bytes(), bytes);
      rock.edit();
    }
  }
}

}  // namespace
}  // namespace vug::volume
