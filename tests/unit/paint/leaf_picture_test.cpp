// SPDX-License-Identifier: Apache-2.0
// Leaf pictures: leaves as cards with an alpha channel, for other programs.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/paint/kind.h>
#include <vug/paint/leaf_pattern.h>
#include <vug/paint/leaf_picture.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace vug::paint {
namespace {

Paint green() {
  return make_paint([](const EvalPoint& point) {
    return Vec3d(0.1, 0.5 + 0.5 * point.attributes->read(kLeafAlong)->x, 0.2);
  });
}
Mask blade() { return make_product(masks(), "leaf_blade", {{"widest", 0.35}, {"tip", 1.4}}); }

TEST(LeafPicture, CoversTheOutline) {
  const LeafPictureOptions options{64, 512, 4};
  const image::Image picture = leaf_picture(green(), blade(), options);
  ASSERT_EQ(picture.channels, (std::vector<std::string>{"R", "G", "B", "A"}));
  const LeafOutline outline{0.35, 1.4};
  double sum = 0, wanted = 0;
  for (int y = 0; y < 512; ++y) {
    const double along = 1 - (y + 0.5) / 512, half = outline.half_width(along);
    wanted += half / 512;
    for (int x = 0; x < 64; ++x) {
      const double across = std::fabs((x + 0.5) / 32 - 1), alpha = picture.at(x, y, 3);
      sum += alpha / (64 * 512);
      if (across > half + 0.06) {
        ASSERT_EQ(alpha, 0) << x << " " << y;
      }
      if (across < half - 0.06) {
        ASSERT_EQ(alpha, 1) << x << " " << y;
      }
      // Colours continue outside the outline, and the tip is at the top.
      ASSERT_NEAR(picture.at(x, y, 1), 0.5 + 0.5 * along, 1e-3);
      ASSERT_NEAR(alpha, picture.at(63 - x, y, 3), 1e-6) << "both halves are alike";
    }
  }
  EXPECT_NEAR(sum, wanted, 0.002);
}

TEST(LeafPicture, IsAFileWithAlphaAndTheSameForAnyNumberOfThreads) {
  const image::Image picture = leaf_picture(green(), blade(), {16, 96, 2});
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] { EXPECT_EQ(leaf_picture(green(), blade(), {16, 96, 2}), picture); });
  }
  const ScratchFolder scratch("vug_leaf");
  const auto path = scratch.file("leaf.exr");
  image::write_exr(path, picture);
  const image::Image back = image::read(path).select({"R", "G", "B", "A"});
  EXPECT_EQ(back.pixels, picture.pixels);
}

TEST(LeafPicture, WithoutOpacityIsOpaque) {
  const image::Image picture = leaf_picture(green(), nullptr, {4, 4, 1});
  for (int y = 0; y < 4; ++y) EXPECT_EQ(picture.at(2, y, 3), 1);
  EXPECT_THROW(leaf_picture(nullptr, nullptr), Error);
  EXPECT_THROW(leaf_picture(green(), nullptr, {0, 4, 1}), Error);
  EXPECT_THROW(leaf_picture(green(), nullptr, {4, 4, 0}), Error);
}

}  // namespace
}  // namespace vug::paint
