// SPDX-License-Identifier: Apache-2.0
// Exposures that follow from the luminance of a picture.
#include <gtest/gtest.h>
#include <vug/image/brightness.h>

#include <cmath>
#include <limits>

namespace vug::image {
namespace {

/// A grey picture; each luminance fills the given number of pixels.
Image picture_of(const std::vector<std::pair<size_t, float>>& areas) {
  std::vector<float> pixels;
  for (const auto& [count, luminance] : areas) pixels.insert(pixels.end(), 3 * count, luminance);
  Image out(static_cast<int>(pixels.size() / 3), 1, {"R", "G", "B"});
  out.pixels = pixels;
  return out;
}

/// The luminance that the exposure makes of another.
double exposed(double luminance, const Image& picture) {
  return luminance * std::exp2(metered_exposure(picture).value());
}

TEST(View, GreyExposureIsThatOfTheGeometricMean) {
  Image picture(3, 1, {"R", "G", "B"});
  for (size_t i = 0; i < 3; ++i) picture.pixels[i] = 0.18f / 64;  // Six stops below.
  for (size_t i = 3; i < 6; ++i) picture.pixels[i] = 0.18f * 4;   // Two above; the third is black.
  ASSERT_TRUE(grey_exposure(picture));
  EXPECT_NEAR(*grey_exposure(picture), 2, 1e-6);
  EXPECT_FALSE(grey_exposure(Image(2, 2, {"R", "G", "B"})));
  EXPECT_FALSE(grey_exposure(Image(2, 2, {"Z"})));
}

TEST(Metering, TheMedianOfTheLitPartIsMiddleGrey) {
  for (const float scale : {1e-4f, 1.0f, 1e4f})
    EXPECT_NEAR(exposed(double{scale}, picture_of({{100, scale}})), 0.16, 1e-6);
}

TEST(Metering, ADarkForegroundDoesNotBrightenThePicture) {
  const Image lit = picture_of({{300, 1}}), framed = picture_of({{600, 0.001f}, {300, 1}});
  EXPECT_EQ(metered_exposure(lit), metered_exposure(framed));
}

TEST(Metering, HighlightsLimitTheExposure) {
  const Image sky = picture_of({{900, 0.01f}, {100, 40}});
  EXPECT_NEAR(exposed(40, sky), 6, 1e-6);
  // A bare lamp of a few pixels does not.
  const Image lamp = picture_of({{998, 0.01f}, {2, 4000}});
  EXPECT_NEAR(exposed(0.01, lamp), 0.16, 1e-6);
}

TEST(Metering, BrokenPixelsCountAsBlackAndBlackPicturesHaveNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NEAR(exposed(1, picture_of({{50, nan}, {50, 1}})), 0.16, 1e-6);
  EXPECT_FALSE(metered_exposure(picture_of({{9, 0}})));
  EXPECT_FALSE(metered_exposure(Image(2, 2, {"Z"})));
}

}  // namespace
}  // namespace vug::image
