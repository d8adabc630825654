// SPDX-License-Identifier: Apache-2.0
// The parameter `distance` of level sets.
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/building/builder.h>
#include <vug/building/level_set_for_files.h>
#include <vug/loading/load.h>
#include <vug/mesh/distance.h>
#include <vug/meshing/polygonize.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::building {
namespace {

using shot::DistanceValues;

loading::Loaded loaded(const std::string& text, const loading::LoadOptions& options = {}) {
  loading::Loaded made = loading::load_text(text, "t.vug", options);
  EXPECT_EQ(made.report(), "");
  return made;
}

struct File {
  volume::LevelSet level_set;
  std::string distance;  ///< Its metadata.
};

File file_of(const std::string& parameters, DistanceValues automatic) {
  const loading::Loaded scene = loaded(
      "volume rock = level_set(box(size: (1, 1, 1)) - sphere(60cm).translate((0, 50cm, 0)), "
      "voxel: 10cm" +
      parameters + ")");
  Builder builder(scene.shot);
  const volume::LevelSet made = level_set_for_files(builder, scene.shot.volumes.at(0), automatic);
  const volume::Metadata metadata = made.metadata();
  const auto found = metadata.find("vug:distance");
  return {made, found == metadata.end() ? "" : std::get<std::string>(found->second)};
}

TEST(LevelSetForFiles, ExportsHaveExactDistancesAndBuildsBounds) {
  const File build = file_of("", DistanceValues::bound);
  const File exported = file_of("", DistanceValues::exact);
  EXPECT_EQ(build.distance, "");
  EXPECT_EQ(exported.distance, "exact");
  EXPECT_FALSE(build.level_set.content() == exported.level_set.content());
  const File exact = file_of(", distance: exact", DistanceValues::bound);
  EXPECT_EQ(exact.distance, "exact");
  EXPECT_EQ(exact.level_set.content(), exported.level_set.content());
  const File bound = file_of(", distance: bound", DistanceValues::exact);
  EXPECT_EQ(bound.distance, "bound");
  EXPECT_EQ(bound.level_set.content(), build.level_set.content());
}

TEST(LevelSetForFiles, MeshesDoNotDependOnTheDistance) {
  const std::string solid = "volume rock = level_set(box(size: (1, 1, 1)) - sphere(60cm), voxel: ";
  const loading::Loaded bound = loaded(solid + "10cm)\nmesh skin on rock {}");
  const loading::Loaded exact = loaded(solid + "10cm, distance: exact)\nmesh skin on rock {}");
  Builder one(bound.shot), other(exact.shot);
  EXPECT_EQ(*one.mesh(bound.shot.meshes.at(0)), *other.mesh(exact.shot.meshes.at(0)));
}

TEST(LevelSetForFiles, ExactDistancesAreRefusedIfTheirPolygonsNeedTooMuchMemory) {
  const loading::Loaded scene = loaded("volume rock = level_set(sphere(1m) & box(), voxel: 1cm)");
  const shot::VolumePtr plan = scene.shot.volumes.at(0);
  BuildOptions options;
  options.max_memory = 40000000;
  Builder builder(scene.shot, options);
  EXPECT_NO_THROW(level_set_for_files(builder, plan, DistanceValues::bound));
  try {
    level_set_for_files(builder, plan, DistanceValues::exact);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
  }
}

/// Cornices, windows, reveals and sills: edges of all kinds, at lattice placements that fit none.
TEST(LevelSetForFiles, DistancesToAFacadeAreExact) {
  constexpr double kVoxel = 0.05;
  const loading::Loaded scene = loaded(R"(
grammar front: facade {
  width 1.6m
  height 1.4m
  axiom Bay
  Bay -> inset(35cm, window(reveal: 20cm, sash: 0cm))
}
volume rock = level_set(carve(box(size: (1.6, 1.4, 0.6)).translate((0, 0.7, -0.3)), front)
  .rotate(axis: (1, 2, 3), angle: 20deg), voxel: 5cm)
)");
  const shot::VolumePtr plan = scene.shot.volumes.at(0);
  Builder builder(scene.shot);
  volume::VoxelizeOptions fine;
  fine.voxel = kVoxel / 8;
  const mesh::MeshDistance truth(
      meshing::polygonize(volume::voxelize(plan->field, fine), &plan->field).mesh);
  const auto largest_error = [&](DistanceValues values) {
    const volume::LevelSet made = level_set_for_files(builder, plan, values);
    double largest = 0;
    RandomStream random(RandomKey(1));
    for (int i = 0; i < 50000; ++i) {
      Vec3d p;
      for (int axis = 0; axis < 3; ++axis)
        p[axis] = std::floor(random.uniform(-1.2, 1.8) / kVoxel) * kVoxel;
      const double value = std::fabs(made.value(p));
      const double exact = std::min(truth.closest(p).distance, made.background());
      if (exact < made.background()) largest = std::max(largest, std::fabs(value - exact));
    }
    return largest / kVoxel;
  };
  EXPECT_GT(largest_error(DistanceValues::bound), 1);
  // The largest error, 0.053, is that of a voxel next to the end of the band.
  EXPECT_LT(largest_error(DistanceValues::exact), 0.06);
}

}  // namespace
}  // namespace vug::building
