// SPDX-License-Identifier: Apache-2.0
// Calibration and power of the significance test on images with known noise.
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/image/significance.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::image {
namespace {

constexpr int kWidth = 64, kHeight = 36;

/// The expected value of a pixel: a gradient from bright to dark, with a light in view.
double expected(int x, int y) {
  if (x >= 50 && x < 54 && y >= 4 && y < 8) return 40;
  return 0.01 + 0.4 * (1 + std::sin(0.2 * x) * std::cos(0.3 * y)) / (1 + 0.1 * x);
}

/// A simulated render: most samples see half of the light, and one in `rarity` sees the rest at
/// once, which makes the noise as skewed as that of a path tracer.
struct Camera {
  int spp = 64;
  double rarity = 20;
  double gain = 1;     ///< Factor on all light.
  bool patch = false;  ///< Another material on 6 x 5 pixels: a fifth brighter.

  NoisyPicture render(uint64_t seed) const {
    NoisyPicture out;
    out.mean = Image(kWidth, kHeight, {"R", "G", "B"});
    out.variance = out.mean;
    out.samples.assign(out.mean.pixel_count(), static_cast<float>(spp));
    RandomStream random(RandomKey(seed).at("camera"));
    for (int y = 0; y < kHeight; ++y)
      for (int x = 0; x < kWidth; ++x) {
        const bool other = patch && x >= 20 && x < 26 && y >= 15 && y < 20;
        const double mean = gain * (other ? 1.2 : 1) * expected(x, y);
        const bool light = expected(x, y) > 30;
        double sum = 0, squares = 0;
        for (int i = 0; i < spp; ++i) {
          const double rare = random.uniform() * rarity < 1 ? 0.5 * mean * rarity : 0;
          const double v = light ? mean : 0.5 * mean + rare;
          sum += v, squares += v * v;
        }
        const double m = sum / spp, variance = (squares / spp - m * m) / (spp - 1);
        for (size_t c = 0; c < 3; ++c) {
          out.mean.at(x, y, c) = static_cast<float>(m);
          out.variance->at(x, y, c) = static_cast<float>(std::max(variance, 0.0));
        }
      }
    return out;
  }
};

TEST(NormalTail, MatchesTheTables) {
  EXPECT_DOUBLE_EQ(two_sided_p_value(0), 1);
  EXPECT_NEAR(two_sided_p_value(1), 0.31731050786291, 1e-12);
  EXPECT_NEAR(two_sided_p_value(-1.959963984540054), 0.05, 1e-12);
  EXPECT_NEAR(two_sided_p_value(2.8), 0.005110260660855, 1e-12);
  EXPECT_NEAR(two_sided_p_value(2.85), 0.004371922909826489, 1e-12);
  EXPECT_NEAR(two_sided_p_value(6) / 1.973175290075e-9, 1, 1e-9);
  EXPECT_NEAR(two_sided_p_value(20) / 5.507248237212e-89, 1, 1e-9);
}

/// False alarms among comparisons of renders that differ only by their seed.
int alarms(const Camera& a, const Camera& b, int trials, double rate) {
  SignificanceOptions options;
  options.false_alarm_rate = rate;
  int count = 0;
  for (int i = 0; i < trials; ++i) {
    const auto seed = static_cast<uint64_t>(i);
    if (test_significance(a.render(2 * seed), b.render(2 * seed + 1), {}, options).different)
      ++count;
  }
  return count;
}

/// Approximately the count that a binomial of this rate exceeds once in a thousand times.
double most_of(int trials, double rate) {
  return trials * rate + 3.3 * std::sqrt(trials * rate * (1 - rate)) + 1;
}

TEST(Significance, RaisesNoMoreFalseAlarmsThanChosen) {
  const Camera camera{.spp = 16};
  EXPECT_LE(alarms(camera, camera, 200, 0.01), most_of(200, 0.01));
  EXPECT_LE(alarms(camera, camera, 200, 0.1), most_of(200, 0.1));
}

TEST(Significance, SkewedNoiseOfFewSamplesIsNotADifference) {
  EXPECT_LE(alarms({.spp = 256}, {.spp = 8}, 100, 0.05), most_of(100, 0.05));
  EXPECT_LE(alarms({.spp = 8}, {.spp = 256}, 100, 0.05), most_of(100, 0.05));
}

TEST(Significance, FindsOnePercentLessLight) {
  for (uint64_t i = 0; i < 10; ++i) {
    const auto found =
        test_significance(Camera{.spp = 256, .rarity = 4}.render(2 * i),
                          Camera{.spp = 256, .rarity = 4, .gain = 0.99}.render(2 * i + 1));
    EXPECT_TRUE(found.different) << i;
    EXPECT_NEAR(found.bias, -0.01, 0.01);
  }
}

TEST(Significance, FindsADarkerCopyOfTheSamePicture) {
  const NoisyPicture a = Camera{.spp = 256}.render(1);
  NoisyPicture b = a;
  for (float& v : b.mean.pixels) v *= 0.99f;
  EXPECT_TRUE(test_significance(a, b).different);
}

TEST(Significance, FindsAnotherMaterialOnAFewPixels) {
  for (uint64_t i = 0; i < 10; ++i)
    EXPECT_TRUE(test_significance(Camera{.spp = 256, .rarity = 4}.render(2 * i),
                                  Camera{.spp = 256, .rarity = 4, .patch = true}.render(2 * i + 1))
                    .different)
        << i;
}

TEST(Significance, IsSymmetricAndAcceptsEqualImages) {
  const NoisyPicture a = Camera{}.render(1), b = Camera{.gain = 0.95}.render(2);
  const Significance ab = test_significance(a, b), ba = test_significance(b, a);
  EXPECT_EQ(ab.different, ba.different);
  EXPECT_DOUBLE_EQ(ab.p_value, ba.p_value);
  EXPECT_DOUBLE_EQ(ab.mean_z, -ba.mean_z);
  const Significance same = test_significance(a, a);
  EXPECT_FALSE(same.different);
  EXPECT_EQ(same.std_z, 0);
}

TEST(Significance, HalfPrecisionStorageIsNotADifference) {
  const NoisyPicture a = Camera{.spp = 4096, .rarity = 1}.render(1);  // Rarity 1: no noise.
  NoisyPicture b = a;
  for (size_t i = 0; i < b.mean.pixels.size(); ++i) b.mean.pixels[i] *= 1 + 4e-4f;
  const Significance found = test_significance(a, b);
  EXPECT_LT(found.std_z, 1);
  for (const Finding& finding : found.findings)
    EXPECT_TRUE(finding.name == "bias" || !finding.different) << finding.name;
}

TEST(Significance, TheOtherVarianceIsInferredFromTheSamples) {
  const Camera camera{.spp = 64};
  NoisyPicture a = camera.render(1);
  const NoisyPicture b = camera.render(2);
  const double both = test_significance(a, b).std_z;
  a.variance.reset();
  EXPECT_NEAR(test_significance(a, b).std_z / both, 1, 0.05);
  a.samples.clear();  // Now taken as exact: half of the variance, and of the noise, is unexplained.
  EXPECT_NEAR(test_significance(a, b).std_z / both, std::sqrt(2.0), 0.1);
}

TEST(Significance, MasksExcludePixels) {
  const NoisyPicture a = Camera{.spp = 256, .rarity = 4}.render(1);
  NoisyPicture b = Camera{.spp = 256, .rarity = 4, .patch = true}.render(2);
  std::vector<uint8_t> mask(a.mean.pixel_count(), 1);
  for (int y = 15; y < 20; ++y)
    for (int x = 20; x < 26; ++x) mask[static_cast<size_t>(y * kWidth + x)] = 0;
  EXPECT_TRUE(test_significance(a, b).different);
  EXPECT_FALSE(test_significance(a, b, mask).different);
}

TEST(Significance, RefusesUntestableInput) {
  const NoisyPicture a = Camera{}.render(1);
  NoisyPicture bare = a;
  bare.variance.reset();
  EXPECT_THROW(test_significance(bare, bare), Error);
  EXPECT_THROW(test_significance(a, a, std::vector<uint8_t>(a.mean.pixel_count(), 0)), Error);
  NoisyPicture small = a;
  small.mean = Image(2, 2, {"R", "G", "B"});
  EXPECT_THROW(test_significance(a, small), Error);
}

}  // namespace
}  // namespace vug::image
