// SPDX-License-Identifier: Apache-2.0
// Closed forms of FLIP. tests/cli/flip_test.py compares whole images with another implementation.
#include <vug/image/flip.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::image {
namespace {

Image uniform(float r, float g, float b) {
  Image image(24, 18, {"R", "G", "B"});
  for (size_t i = 0; i < image.pixels.size(); i += 3)
    image.pixels[i] = r, image.pixels[i + 1] = g, image.pixels[i + 2] = b;
  return image;
}

/// Every pixel of two uniform images has the same difference.
double error_of(const Image& a, const Image& b) {
  const Plane error = flip(a, b);
  for (const float v : error.values) EXPECT_NEAR(v, error.values[0], 1e-4);
  return static_cast<double>(error.values[0]);
}

TEST(Flip, BlackAgainstWhite) {
  // Without features only colour matters. |L| differs by 100, green and blue (the furthest pair) by
  // 203.3 in Hunt-adjusted HyAB: 100^0.7 = 25.119 and 203.3^0.7 = 41.28, bent at 0.4 of that.
  const double most = std::pow(203.3, 0.7), error = std::pow(100.0, 0.7);
  const double expected = 0.95 + (error - 0.4 * most) / (0.6 * most) * 0.05;
  EXPECT_NEAR(error_of(uniform(0, 0, 0), uniform(1, 1, 1)), expected, 2e-4);
}

TEST(Flip, TheFurthestColoursDifferByOne) {
  EXPECT_NEAR(error_of(uniform(0, 1, 0), uniform(0, 0, 1)), 1, 1e-4);
}

TEST(Flip, SmallStepsOfGreyFollowThePowerLaw) {
  // L* of two greys, from CIE's formula; below the break point the error is 0.95 / (0.4 most)
  // d^0.7.
  const auto lightness = [](double y) { return 116 * std::cbrt(y) - 16; };
  const double d = lightness(0.3) - lightness(0.25), most = std::pow(203.3, 0.7);
  EXPECT_NEAR(error_of(uniform(0.25f, 0.25f, 0.25f), uniform(0.3f, 0.3f, 0.3f)),
              0.95 / (0.4 * most) * std::pow(d, 0.7), 2e-4);
}

TEST(Flip, AnEdgeIsWorseThanItsColours) {
  Image stripe = uniform(0.5f, 0.5f, 0.5f);
  const Image plain = stripe;
  for (int y = 0; y < stripe.height; ++y)
    for (size_t c = 0; c < 3; ++c) stripe.at(12, y, c) = 0.9f;
  const Plane with_edge = flip(plain, stripe);
  const float at_edge = with_edge.values[9 * 24 + 12], far_off = with_edge.values[9 * 24 + 0];
  EXPECT_GT(at_edge, 0.3f);
  EXPECT_LT(far_off, 0.05f);
}

TEST(FlipHdr, RangeOfExposuresByHand) {
  // The curve reaches 0.85 at x: 0.9036 x^2 + 0.018 x = 0.85 (0.8748 x^2 + 0.354 x + 0.14).
  const double a = 0.36 * 2.51 - 0.85 * 0.36 * 2.43, b = 0.6 * 0.03 - 0.85 * 0.6 * 0.59;
  const double x = (-b + std::sqrt(b * b + 4 * a * 0.85 * 0.14)) / (2 * a);
  Image picture = uniform(0.25f, 0.25f, 0.25f);
  for (size_t c = 0; c < 3; ++c) picture.at(0, 0, c) = 16;
  const auto range = exposure_range(picture);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->start, std::log2(x / 16), 1e-6);
  EXPECT_NEAR(range->stop, std::log2(x / 0.25), 1e-6);
  EXPECT_EQ(range->count(), 6);
  EXPECT_FALSE(exposure_range(uniform(0, 0, 0)));
}

TEST(FlipHdr, MostlyBlackPicturesTakeTheMedianOfTheRest) {
  Image picture = uniform(0, 0, 0);
  for (int x = 0; x < 5; ++x)
    for (size_t c = 0; c < 3; ++c) picture.at(x, 0, c) = static_cast<float>(x + 1);
  const auto range = exposure_range(picture);
  ASSERT_TRUE(range);
  EXPECT_NEAR(range->stop - range->start, std::log2(5.0 / 3), 1e-6);
}

TEST(FlipHdr, DetectsDarkDifferencesThatOneExposureHides) {
  Image a = uniform(0.0002f, 0.0002f, 0.0002f), b = a;
  for (size_t c = 0; c < 3; ++c) a.at(0, 0, c) = b.at(0, 0, c) = 8;
  for (int x = 10; x < 16; ++x)
    for (int y = 6; y < 12; ++y)
      for (size_t c = 0; c < 3; ++c) b.at(x, y, c) = 0.0004f;
  const auto range = exposure_range(a);
  ASSERT_TRUE(range);
  const size_t middle = 9 * 24 + 13;
  EXPECT_LT(flip(a, b).values[middle], 0.05f);
  EXPECT_GT(flip_hdr(a, b, *range).values[middle], 0.3f);
}

}  // namespace
}  // namespace vug::image
