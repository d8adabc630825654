// SPDX-License-Identifier: Apache-2.0
// Artefacts that the denoiser must avoid; the tests of the renderer measure its noise reduction.
#include <gtest/gtest.h>
#include <vug/base/rng.h>
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

/// Rock with a tenth of noise, and dots that one sample of sixteen made `ratio` times as bright: a
/// cluster of `dots` of them.
Image with_cluster(int dots, float ratio, bool guided) {
  static constexpr int kPlaces[][2] = {{0, 0}, {1, 0}, {0, 1}, {2, 1}, {1, 2}};
  std::vector<std::string> channels = {"R", "G", "B", "variance.R", "variance.G", "variance.B"};
  if (guided)
    for (const char* name : {"N.X", "N.Y", "N.Z", "Z"}) channels.push_back(name);
  Image out(48, 40, channels);
  RandomStream random(RandomKey(17));
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x) {
      const auto value = static_cast<float>(1 + 0.1 * random.normal());
      for (size_t c = 0; c < 3; ++c) out.at(x, y, c) = value, out.at(x, y, 3 + c) = 0.01f;
      if (guided) out.at(x, y, 8) = 1, out.at(x, y, 9) = 3;
    }
  for (int i = 0; i < dots; ++i)
    for (size_t c = 0; c < 3; ++c) {
      const int x = 24 + kPlaces[i][0], y = 20 + kPlaces[i][1];
      out.at(x, y, c) = ratio, out.at(x, y, 3 + c) = ratio * ratio;
    }
  return out;
}

// Light on bumps follows their normals. A weighted mean flattens it, a regression does not.
TEST(Denoise, LightThatFollowsTheNormalKeepsItsContrast) {
  Image picture(64, 48,
                {"R", "G", "B", "variance.R", "variance.G", "variance.B", "N.X", "N.Y", "N.Z"});
  RandomStream random(RandomKey(3));
  std::vector<float> truth;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto slope = static_cast<float>(0.25 * std::sin(0.8 * x) * std::cos(0.7 * y));
      truth.push_back(1 + slope);
      for (size_t c = 0; c < 3; ++c) {
        picture.at(x, y, c) = truth.back() + static_cast<float>(0.2 * random.normal());
        picture.at(x, y, 3 + c) = 0.04f;
      }
      picture.at(x, y, 6) = slope, picture.at(x, y, 8) = std::sqrt(1 - slope * slope);
    }
  const Image smooth = denoise(picture);
  double error = 0, squares = 0, product = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto true_one = static_cast<double>(truth[static_cast<size_t>(y * 64 + x)]);
      const auto found = static_cast<double>(smooth.at(x, y, 1));
      error += (found - true_one) * (found - true_one);
      squares += (true_one - 1) * (true_one - 1), product += (true_one - 1) * (found - 1);
    }
  EXPECT_LT(std::sqrt(error / (64 * 48)), 0.05) << "a quarter of the noise";
  EXPECT_GT(product / squares, 0.9) << "of the contrast";
}

// Dots of fireflies must not become squares of the size of the filter's window.
TEST(Denoise, ClustersOfDotsDoNotSpread) {
  for (const bool guided : {false, true})
    for (const int dots : {1, 2, 3, 5})
      for (const float ratio : {30.0f, 300.0f, 3000.0f}) {
        const Image smooth = denoise(with_cluster(dots, ratio, guided));
        for (int y = 0; y < smooth.height; ++y)
          for (int x = 0; x < smooth.width; ++x) {
            const bool near = x >= 22 && x <= 28 && y >= 18 && y <= 24;
            if (near) continue;
            ASSERT_NEAR(smooth.at(x, y, 1), 1, 0.05)
                << dots << " dots of " << ratio << " at " << x << ", " << y;
          }
      }
}

// Sparse bright pixels that are the light of a place rather than outliers keep their energy.
TEST(Denoise, ManyBrightPixelsAreLight) {
  Image picture(48, 40, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  RandomStream random(RandomKey(5));
  double before = 0, after = 0;
  for (size_t p = 0; p < picture.pixel_count(); ++p)
    for (size_t c = 0; c < 3; ++c) {
      const float value = random.uniform() < 0.25 ? 4.0f : 0.5f;
      picture.pixels[6 * p + c] = value, picture.pixels[6 * p + 3 + c] = value * value;
      before += static_cast<double>(value);
    }
  for (const float v : denoise(picture).pixels) after += static_cast<double>(v);
  EXPECT_NEAR(after / before, 1, 0.05);
}

}  // namespace
}  // namespace vug::image
