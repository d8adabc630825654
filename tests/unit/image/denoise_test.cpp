// SPDX-License-Identifier: Apache-2.0
// Artefacts that the denoiser must avoid; the tests of the renderer measure its noise reduction.
#include <gtest/gtest.h>
#include <vug/image/denoise.h>

#include <cmath>

namespace vug::image {
namespace {

/// Uniformly lit rock that becomes black from left to right, with the variance of a noisy image.
Image darkening(int width, int height) {
  Image out(width, height,
            {"R", "G", "B", "Z", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B",
             "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const float albedo = 0.04f - 0.035f * static_cast<float>(x) / static_cast<float>(width - 1);
      for (size_t c = 0; c < 3; ++c) {
        out.at(x, y, c) = 0.5f * albedo;
        out.at(x, y, 7 + c) = albedo;
        out.at(x, y, 10 + c) = 0.09f * albedo * albedo;
      }
      out.at(x, y, 3) = 2;
      out.at(x, y, 6) = 1;
    }
  return out;
}

TEST(Denoise, CreatesNoOutlineWhereRockBecomesBlack) {
  const Image picture = darkening(96, 24), smooth = denoise(picture);
  for (int x = 0; x < picture.width; ++x)
    EXPECT_NEAR(smooth.at(x, 12, 0), picture.at(x, 12, 0), 0.1f * picture.at(x, 12, 0) + 5e-4f)
        << x;
}

/// Uniform rock with one pixel that one sample of sixteen made a hundred times as bright.
Image dotted(int width, int height, bool noisy) {
  Image out(width, height, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (size_t c = 0; c < 3; ++c) {
        out.at(x, y, c) = 0.5f;
        out.at(x, y, 3 + c) = 0.01f;
      }
  for (size_t c = 0; c < 3; ++c) {
    out.at(width / 2, height / 2, c) = 50;
    out.at(width / 2, height / 2, 3 + c) = noisy ? 50 * 50 : 1e-4f;
  }
  return out;
}

TEST(Denoise, ANoisyOutlierDoesNotSpread) {
  const Image smooth = denoise(dotted(32, 24, true));
  for (int y = 0; y < smooth.height; ++y)
    for (int x = 0; x < smooth.width; ++x) EXPECT_NEAR(smooth.at(x, y, 0), 0.5, 1e-3);
}

TEST(Denoise, ACertainBrightPixelIsKept) {
  EXPECT_GT(denoise(dotted(32, 24, false)).at(16, 12, 0), 5);
}

}  // namespace
}  // namespace vug::image
