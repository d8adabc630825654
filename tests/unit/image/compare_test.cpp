#include <vug/base/error.h>
#include <vug/image/compare.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vug::image {
namespace {

TEST(Compare, NumbersByHand) {
  Image a(2, 1, {"R", "Z"}), b(2, 1, {"R", "Z"});
  a.pixels = {1, 10, 3, 10};
  b.pixels = {1, 13, 2, 6};
  const auto d = compare(a, b);
  ASSERT_EQ(d.size(), 3u);
  EXPECT_EQ(d[0].channel, "R");
  EXPECT_DOUBLE_EQ(d[0].mean_a, 2);
  EXPECT_DOUBLE_EQ(d[0].mean_b, 1.5);
  EXPECT_DOUBLE_EQ(d[0].rmse, std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(d[0].relative_rmse, std::sqrt(0.5) / 2);
  EXPECT_DOUBLE_EQ(d[1].mean_error, 3.5);
  EXPECT_DOUBLE_EQ(d[1].max_error, 4);
  EXPECT_EQ(d[2].channel, "all");
  EXPECT_DOUBLE_EQ(d[2].rmse, std::sqrt((1 + 9 + 16) / 4.0));
}

TEST(Compare, IsSymmetricAndZeroOnEqual) {
  Image a(8, 8, {"R", "G", "B"}), b = a;
  for (size_t i = 0; i < a.pixels.size(); ++i) b.pixels[i] = static_cast<float>(i % 7);
  EXPECT_EQ(compare(a, a).back().max_error, 0);
  EXPECT_EQ(compare(a, b).back().rmse, compare(b, a).back().rmse);
}

TEST(Compare, ValuesThatAreNotFiniteCount) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Image a(1, 1, {"R"}), b(1, 1, {"R"});
  a.pixels = {nan};
  EXPECT_EQ(compare(a, a).back().max_error, 0);
  EXPECT_TRUE(std::isinf(compare(a, b).back().max_error));
  EXPECT_TRUE(std::isinf(compare(b, a).back().max_error));
}

TEST(Compare, RefusesDifferentShapes) {
  EXPECT_THROW(compare(Image(2, 1, {"R"}), Image(1, 2, {"R"})), Error);
  EXPECT_THROW(compare(Image(2, 1, {"R"}), Image(2, 1, {"G"})), Error);
}

}  // namespace
}  // namespace vug::image
