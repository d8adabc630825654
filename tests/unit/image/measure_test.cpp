// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/base/srgb.h>
#include <vug/image/measure.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vug::image {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

Image noise(uint64_t seed, double scale = 1) {
  Image image(40, 30, {"R", "G", "B"});
  RandomStream random(RandomKey(seed).at("measure"));
  for (float& v : image.pixels) v = static_cast<float>(scale * random.uniform());
  return image;
}

Image flat(float value, int width = 32, int height = 24) {
  Image image(width, height, {"R", "G", "B"});
  for (float& v : image.pixels) v = value;
  return image;
}

/// Display values as they are: no curve, no exposure.
Comparison as_shown(Image reference, Image test) {
  Comparison pair;
  pair.reference = std::move(reference), pair.test = std::move(test);
  pair.view.transform = ViewTransform::srgb;
  return pair;
}

TEST(Measures, AreZeroOrOneOnEqualPicturesAndSymmetric) {
  const Image a = noise(1, 2), b = noise(2);
  for (const Measure* each : measures()) {
    SCOPED_TRACE(each->info.name);
    EXPECT_EQ(measure(each->info.name, a, a), each->equal);
    const double ab = measure(each->info.name, a, b), ba = measure(each->info.name, b, a);
    EXPECT_DOUBLE_EQ(ab, ba);
    EXPECT_TRUE(each->better == Measure::Better::low ? ab > each->equal : ab < each->equal);
    EXPECT_FALSE(each->info.doc.empty());
  }
}

TEST(Measures, OfAConstantOffset) {
  const Image a = flat(0.5f), b = flat(0.75f);
  EXPECT_DOUBLE_EQ(measure("rmse", a, b), 0.25);
  EXPECT_DOUBLE_EQ(measure("mean", a, b), 0.25);
  EXPECT_DOUBLE_EQ(measure("max", a, b), 0.25);
  EXPECT_DOUBLE_EQ(measure("relative_rmse", a, b), 0.25 / 0.625);
  EXPECT_DOUBLE_EQ(measure("relative_max", a, b), 0.25 / 0.75);
}

TEST(Measures, NumbersByHand) {
  Image a(2, 1, {"Z"}), b(2, 1, {"Z"});
  a.pixels = {1, 3};
  b.pixels = {1, 2};
  EXPECT_DOUBLE_EQ(measure("rmse", a, b), std::sqrt(0.5));
  EXPECT_DOUBLE_EQ(measure("mean", a, b), 0.5);
  EXPECT_DOUBLE_EQ(measure("relative_rmse", a, b), std::sqrt(0.5) / 1.75);
  EXPECT_DOUBLE_EQ(measure("relative_max", a, b), 1.0 / 3);
}

TEST(Measures, PsnrOfAConstantDisplayOffset) {
  // Display values 0.5 and 0.6: 10 log10(1 / 0.1^2) = 20 dB.
  const auto light = [](double shown) { return static_cast<float>(srgb_decode(shown)); };
  const Comparison pair = as_shown(flat(light(0.5)), flat(light(0.6)));
  EXPECT_NEAR(measure_of("psnr").measure(pair).value, 20, 1e-4);
  const double black_and_white = measure_of("psnr").measure(as_shown(flat(0), flat(1))).value;
  EXPECT_TRUE(black_and_white == 0 && !std::signbit(black_and_white)) << "not -0";
}

TEST(Measures, SsimOfFlatPicturesIsTheLuminanceTerm) {
  // Without structure only (2 a b + C1) / (a^2 + b^2 + C1) remains.
  const auto light = [](double shown) { return static_cast<float>(srgb_decode(shown)); };
  const Comparison pair = as_shown(flat(light(0.5)), flat(light(0.8)));
  const double expected = (2 * 0.5 * 0.8 + 1e-4) / (0.25 + 0.64 + 1e-4);
  // Squares are stored as floats: their rounding error, 3e-8, compares with C2 = 9e-4.
  EXPECT_NEAR(measure_of("ssim").measure(pair).value, expected, 1e-4);
}

TEST(Measures, SsimOfAnInvertedPatternIsNegative) {
  Image a = flat(0), b = a;
  for (int y = 0; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      for (size_t c = 0; c < 3; ++c) {
        a.at(x, y, c) = (x / 2 + y / 2) % 2 == 0 ? 1.0f : 0.0f;
        b.at(x, y, c) = 1 - a.at(x, y, c);
      }
  EXPECT_LT(measure_of("ssim").measure(as_shown(a, b)).value, -0.9);
}

TEST(Measures, MaskedPixelsDoNotCount) {
  Comparison pair = as_shown(flat(0.5f), flat(0.5f));
  pair.test.at(3, 2, 1) = 100;
  pair.test.at(4, 2, 1) = kNan;
  pair.mask.assign(pair.pixel_count(), 1);
  pair.mask[2 * 32 + 3] = pair.mask[2 * 32 + 4] = 0;
  for (const char* name : {"rmse", "relative_rmse", "mean", "max", "relative_max"})
    EXPECT_EQ(measure_of(name).measure(pair).value, 0) << name;
  EXPECT_TRUE(std::isinf(measure_of("psnr").measure(pair).value));
  EXPECT_EQ(measure_of("max").measure(pair).map[2 * 32 + 3], 99.5f);  // The map still shows it.
}

TEST(Measures, ValuesThatAreNotFiniteCount) {
  Image a(1, 1, {"R"}), b(1, 1, {"R"});
  a.pixels = {kNan};
  for (const char* name : {"rmse", "relative_rmse", "mean", "max", "relative_max"}) {
    EXPECT_EQ(measure(name, a, a), 0) << name;
    EXPECT_TRUE(std::isinf(measure(name, a, b))) << name;
    EXPECT_TRUE(std::isinf(measure(name, b, a))) << name;
  }
}

TEST(Measures, UnusualImagesGiveNumbers) {
  Image a = flat(0), b = flat(0);
  a.at(1, 1, 0) = std::numeric_limits<float>::infinity();
  a.at(2, 1, 1) = kNan;
  b.at(5, 5, 2) = -3;
  b.at(6, 5, 2) = 1e30f;
  for (const char* name : {"flip", "flip_hdr", "ssim"}) {
    const double value = measure(name, a, b);
    EXPECT_GE(value, -1) << name;
    EXPECT_LE(value, 1) << name;
  }
}

TEST(Measures, RefuseDifferentShapesAndUnknownNames) {
  EXPECT_THROW(measure("rmse", Image(2, 1, {"R"}), Image(1, 2, {"R"})), Error);
  EXPECT_THROW(measure("rmse", Image(2, 1, {"R"}), Image(2, 1, {"G"})), Error);
  try {
    measure_of("rsme");
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.hint(), "did you mean 'rmse'?");
  }
}

}  // namespace
}  // namespace vug::image
