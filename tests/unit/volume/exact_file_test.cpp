// SPDX-License-Identifier: Apache-2.0
#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/field/registry.h>
#include <vug/volume/exact_file.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

namespace vug::volume {
namespace {

TEST(ExactFile, ReturnsTheSameLevelSet) {
  const ScratchFolder scratch("vug_exact_test");
  const field::Field solids[] = {field::make("sphere", {{"radius", 1.3}}),
                                 field::make("box", {{"size", Vec3d(4, 3, 5)}}), field::Field()};
  for (const field::Field& solid : solids) {
    VoxelizeOptions options;
    options.voxel = 0.07;
    const LevelSet before = voxelize(solid, options);
    write_exact(scratch.file("a.vdb"), before);
    const LevelSet after = read_exact(scratch.file("a.vdb"));
    EXPECT_EQ(after.content(), before.content());
    EXPECT_EQ(after.name(), before.name());
    EXPECT_EQ(after.metadata(), before.metadata());
    EXPECT_EQ(after.voxel(), before.voxel());
    EXPECT_EQ(after.background(), before.background());
    EXPECT_EQ(after.statistics().active_voxels, before.statistics().active_voxels);
    EXPECT_EQ(after.statistics().memory_bytes, before.statistics().memory_bytes);
    write_exact(scratch.file("b.vdb"), after);
    EXPECT_EQ(read_text(scratch.file("a.vdb")), read_text(scratch.file("b.vdb")));
  }
}

}  // namespace
}  // namespace vug::volume
