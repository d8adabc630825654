// SPDX-License-Identifier: Apache-2.0
// The mesh of a rock whose blocks are edited one after another has the bytes of a mesh that is made
// from scratch, and only the points near the edited block are polished.
#include "solids.h"

#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/displace.h>
#include <vug/meshing/polish_cache.h>

#include <gtest/gtest.h>

#include <optional>

namespace vug::meshing {
namespace {

using field::Field;

constexpr double kRockVoxel = 0.06;

/// Blocks with creases on rough ground, close enough for folds and crossings.
class EditedRock {
 public:
  /// `size`: the side of the ground in metres.
  explicit EditedRock(uint64_t seed, double size = 4) : size_(size), random_(RandomKey(seed)) {
    for (int i = 0; i < static_cast<int>(1.5 * size); ++i) blocks_.push_back(new_block());
  }
  void edit() { blocks_[random_.below(static_cast<uint32_t>(blocks_.size()))] = new_block(); }
  Field field() const {
    const Field ground =
        field::displaced(field::make("box", {{"size", Vec3d(size_, 1, size_)}}),
                         field::make_noise("fbm", {{"scale", 0.8}}), field::Displacement());
    return field::unite({ground, field::unite(blocks_)}, {field::Profile::smooth, 0.04});
  }

 private:
  Field new_block() {
    const double reach = 0.5 * size_ - 0.5;
    const double x = random_.uniform(-reach, reach), y = random_.uniform(0, 0.5),
                 z = random_.uniform(-reach, reach), turn = random_.uniform(0, 3);
    return turned(field::make("box", {{"size", Vec3d(0.9, 0.4, 0.7)}}), {1, 2, 0.5}, turn,
                  {x, y, z});
  }

  double size_;
  RandomStream random_;
  std::vector<Field> blocks_;
};

volume::LevelSet voxels_of(const Field& field) {
  volume::VoxelizeOptions options;
  options.voxel = kRockVoxel;
  return volume::voxelize(field, options);
}

void expect_equal(const PolygonizeResult& a, const PolygonizeResult& b, const std::string& what) {
  EXPECT_EQ(mesh::digest(a.mesh), mesh::digest(b.mesh)) << what;
  EXPECT_EQ(a.report.crease_vertices, b.report.crease_vertices) << what;
  EXPECT_EQ(a.report.shortened_moves, b.report.shortened_moves) << what;
  EXPECT_EQ(a.report.max_residual, b.report.max_residual) << what;
}

TEST(PolishCaches, EditsEqualANewMesh) {
  EditedRock rock(4, 9);
  PolishCache cache;
  for (int i = 0; i < 4; ++i) {
    const Field field = rock.field();
    const volume::LevelSet voxels = voxels_of(field);
    const GroupCounts before = cache.counts();
    const PolygonizeResult edited = polygonize(voxels, &field, {}, cache);
    expect_equal(edited, polygonize(voxels, &field), "edit " + std::to_string(i));
    EXPECT_GT(edited.report.crease_vertices, 0u);
    const uint64_t evaluated = cache.counts().evaluated - before.evaluated,
                   reused = cache.counts().reused - before.reused;
    if (i == 0) {
      EXPECT_EQ(reused, 0u);
      EXPECT_GT(evaluated, 1000u);
    } else {
      EXPECT_GE(evaluated, 1u) << i;
      EXPECT_GT(reused, evaluated) << i;
    }
    rock.edit();
  }
}

TEST(PolishCaches, CountAllGroups) {
  EditedRock rock(5);
  const auto polish = [&](PolishCache& cache) {
    const Field field = rock.field();
    const GroupCounts before = cache.counts();
    polygonize(voxels_of(field), &field, {}, cache);
    return GroupCounts{cache.counts().evaluated - before.evaluated,
                       cache.counts().reused - before.reused};
  };
  PolishCache cache, fresh;
  const GroupCounts first = polish(cache), again = polish(cache);
  EXPECT_EQ(first.reused, 0u);
  EXPECT_EQ(again.evaluated, 0u);
  EXPECT_EQ(again.reused, first.evaluated);
  rock.edit();
  const GroupCounts edit = polish(cache);
  EXPECT_GE(edit.evaluated, 1u);
  EXPECT_EQ(edit.evaluated + edit.reused, polish(fresh).evaluated);
}

TEST(PolishCaches, DoNotDependOnThreads) {
  std::optional<GroupCounts> expected;
  for (const int threads : {1, 2, 7})
    with_threads(threads, [&] {
      EditedRock rock(6);
      PolishCache cache;
      for (int i = 0; i < 2; ++i) {
        const Field field = rock.field();
        const volume::LevelSet voxels = voxels_of(field);
        expect_equal(polygonize(voxels, &field, {}, cache), polygonize(voxels, &field),
                     std::to_string(threads) + " threads");
        rock.edit();
      }
      if (!expected) expected = cache.counts();
      EXPECT_EQ(cache.counts().evaluated, expected->evaluated) << threads;
      EXPECT_EQ(cache.counts().reused, expected->reused) << threads;
    });
}

TEST(PolishCaches, DistinguishOptions) {
  const EditedRock rock(8);
  const Field field = rock.field();
  const volume::LevelSet voxels = voxels_of(field);
  PolishCache cache;
  PolygonizeOptions options;
  polygonize(voxels, &field, options, cache);
  const auto check = [&](const char* what) {
    expect_equal(polygonize(voxels, &field, options, cache), polygonize(voxels, &field, options),
                 what);
  };
  options.crease_angle = 60;
  check("angle");
  options.max_move = 0.5;
  check("move");
  options.creases = false;
  check("creases");
  options.polish = false;
  check("polish");
  options.normals = false;
  check("normals");
  options = {};
  options.adaptivity = 0.5;
  check("adaptivity");
  expect_equal(polygonize(voxels, nullptr, options, cache), polygonize(voxels, nullptr, options),
               "without the field");
}

TEST(PolishCaches, OfAnySizeGiveTheSameMesh) {
  for (const uint64_t bytes : {uint64_t{0}, uint64_t{100000}}) {
    EditedRock rock(10);
    PolishCache cache(bytes);
    for (int i = 0; i < 2; ++i) {
      const Field field = rock.field();
      const volume::LevelSet voxels = voxels_of(field);
      expect_equal(polygonize(voxels, &field, {}, cache), polygonize(voxels, &field),
                   std::to_string(bytes));
      EXPECT_LE(cache.bytes(), bytes);
      rock.edit();
    }
  }
}

}  // namespace
}  // namespace vug::meshing
