// SPDX-License-Identifier: Apache-2.0
#include <vug/base/srgb.h>
#include <vug/image/view.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vug::image {
namespace {

Image grey(float v) {
  Image image(1, 1, {"R", "G", "B"});
  image.pixels = {v, v, v};
  return image;
}

TEST(View, SrgbMatchesTheStandardAndInverts) {
  EXPECT_NEAR(srgb_encode(0.0031308), 0.04045, 1e-5);    // The junction of the two branches.
  EXPECT_NEAR(srgb_encode(0.2158605), 0.5019608, 1e-6);  // Code 128.
  for (int i = 0; i <= 1000; ++i)
    EXPECT_NEAR(srgb_decode(srgb_encode(i / 1000.0)), i / 1000.0, 1e-12);
}

TEST(View, FilmicIncreasesWithoutEarlyClipping) {
  float last = -1;
  for (double stops = -12; stops <= 6; stops += 0.25) {
    const float v = display(grey(static_cast<float>(0.18 * std::exp2(stops)))).pixels[0];
    EXPECT_GE(v, last) << stops;
    last = v;
  }
  EXPECT_LT(display(grey(4)).pixels[0],
            0.99f);  // A shoulder without clipping, four stops above grey.
  EXPECT_EQ(display(grey(0)).pixels[0], 0.0f);
}

TEST(View, GreyStaysGrey) {
  for (const float v : {0.01f, 0.18f, 1.0f, 8.0f}) {
    const Image out = display(grey(v));
    EXPECT_NEAR(out.pixels[0], out.pixels[1], 2e-3);
    EXPECT_NEAR(out.pixels[1], out.pixels[2], 2e-3);
  }
}

TEST(View, ExposureIsAGain) {
  ViewOptions brighter;
  brighter.exposure = 2;
  EXPECT_NEAR(display(grey(0.1f), brighter).pixels[0], display(grey(0.4f)).pixels[0], 1e-6);
}

TEST(View, HandlesNanAndInfinity) {
  for (const float v : {std::numeric_limits<float>::infinity(), -1.0f, 1e30f,
                        std::numeric_limits<float>::quiet_NaN()}) {
    const float out = display(grey(v)).pixels[0];
    EXPECT_GE(out, 0.0f);
    EXPECT_LE(out, 1.0f);
  }
}

}  // namespace
}  // namespace vug::image
