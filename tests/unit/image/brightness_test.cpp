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

/// The same with alpha; `sky` pixels of that luminance have none.
Image with_sky(const std::vector<std::pair<size_t, float>>& areas, size_t count, float luminance) {
  std::vector<std::pair<size_t, float>> all = areas;
  all.emplace_back(count, luminance);
  const Image plain = picture_of(all);
  Image out(plain.width, 1, {"R", "G", "B", "A"});
  const size_t pixels = plain.pixel_count();
  for (size_t p = 0; p < pixels; ++p) {
    for (size_t c = 0; c < 3; ++c) out.pixels[4 * p + c] = plain.pixels[3 * p + c];
    out.pixels[4 * p + 3] = p < pixels - count ? 1.0f : 0.0f;
  }
  return out;
}

TEST(Metering, ACaveBehindABrightMouthIsNotBlack) {
  // The sky is eleven stops brighter than the rock: it becomes white rather than the rock black.
  const Image mouth = with_sky({{850, 0.05f}}, 150, 100);
  EXPECT_NEAR(exposed(0.05, mouth), 0.06, 1e-6);
  // A sky that the picture can show together with the rock does not change the exposure.
  EXPECT_NEAR(exposed(0.05, with_sky({{850, 0.05f}}, 150, 1)), 0.16, 1e-6);
  EXPECT_NEAR(exposed(1, with_sky({{20, 1}}, 980, 1)), 0.16, 1e-6) << "hardly any surface";
}

TEST(Metering, ASunbeamDoesNotMakeTheRestBlack) {
  for (const float ratio : {30.0f, 100.0f, 400.0f}) {
    const Image beam = picture_of({{880, 1}, {120, ratio}});
    EXPECT_LE(exposed(ratio, beam), 3.0001) << ratio;
    EXPECT_GE(exposed(1, beam), std::min(0.0599, 2.9 / ratio)) << ratio;
  }
  // Half of the rock is lit: the other half may be black.
  const Image lamp = picture_of({{500, 0.005f}, {500, 1}});
  EXPECT_NEAR(exposed(1, lamp), 0.16, 1e-6);
  // Surfaces without any light do not count.
  const Image dark = picture_of({{880, 1e-5f}, {120, 1}});
  EXPECT_NEAR(exposed(1, dark), 0.16, 1e-6);
}

TEST(Metering, IsContinuousInTheShareOfTheLitPart) {
  const auto stops = [](size_t lit) {
    return *metered_exposure(picture_of({{1000 - lit, 0.01f}, {lit, 1}}));
  };
  // Below, the 90th percentile jumps.
  for (size_t lit = 102; lit <= 600; ++lit) EXPECT_NEAR(stops(lit), stops(lit - 1), 0.05) << lit;
}

TEST(Metering, BrokenPixelsCountAsBlackAndBlackPicturesHaveNone) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_NEAR(exposed(1, picture_of({{50, nan}, {50, 1}})), 0.16, 1e-6);
  EXPECT_FALSE(metered_exposure(picture_of({{9, 0}})));
  EXPECT_FALSE(metered_exposure(Image(2, 2, {"Z"})));
}

}  // namespace
}  // namespace vug::image
