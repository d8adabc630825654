// SPDX-License-Identifier: Apache-2.0
// Estimates of pictures use the level sets that are in a store.
#include <gtest/gtest.h>
#include <vug/base/scratch_folder.h>
#include <vug/building/builder.h>
#include <vug/farm/estimate.h>
#include <vug/loading/load.h>

namespace vug::farm {
namespace {

TEST(Estimate, CountsTheVoxelsOfLevelSetsInTheStore) {
  const loading::Loaded loaded = loading::load_text(
      "volume rock = level_set(box(size: (6, 4, 6)) - sphere(1.8m), voxel: 20cm)\n"
      "camera main { eye (-1.2, 0.3, 0.4)  target (1, 0, 0) }\n"
      "render main { size 24x16  spp 8 }\n",
      "t.vug");
  const picture::PicturePlan plan = picture::plan_picture(loaded.shot);
  const ScratchFolder folder("vug_estimate");
  building::BuildOptions options;
  options.stored.least_seconds = 0;
  options.stored.store =
      std::make_shared<store::Store>(store::StoreOptions{folder.path(), 1'000'000'000});
  const auto estimated = [&] {
    return estimate_picture(plan, 1, {}, Progress::none(), options.stored);
  };
  const PictureCost sampled = estimate_picture(plan, 1);
  EXPECT_EQ(estimated().voxels, sampled.voxels) << "the store is empty";

  building::Builder builder(loaded.shot, options);
  const auto size = builder.level_set(loaded.shot.volumes.at(0)).statistics();
  EXPECT_EQ(estimated().voxels, static_cast<double>(size.active_voxels));
  EXPECT_NE(sampled.voxels, static_cast<double>(size.active_voxels));
  EXPECT_NEAR(sampled.voxels / static_cast<double>(size.active_voxels), 1, 0.3);
  EXPECT_GT(estimated().bytes, static_cast<double>(size.memory_bytes));
}

TEST(Estimate, StartsOfProcessesTakeLongerWithMoreTriangles) {
  const auto start = [](const char* voxel) {
    const loading::Loaded loaded = loading::load_text(
        std::string("volume rock = level_set(sphere(1.8m), voxel: ") + voxel + ")\n", "t.vug");
    return estimate_picture(picture::plan_picture(loaded.shot), 1).start_seconds;
  };
  EXPECT_GE(start("40cm"), Rates().start_seconds);
  EXPECT_GT(start("5cm"), start("40cm"));
}

}  // namespace
}  // namespace vug::farm
