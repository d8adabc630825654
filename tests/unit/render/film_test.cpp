// SPDX-License-Identifier: Apache-2.0
// Compares the film's sums with exact arithmetic, and its variance with repeated renders.
#include <vug/base/rng.h>
#include <vug/render/film/film.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "scenes.h"

namespace vug::render {
namespace {

/// Random path results: radiances over forty powers of two, and random values of the other fields.
std::vector<PathResult> some_samples(size_t count) {
  RandomStream random(RandomKey(3).at("film"));
  std::vector<PathResult> samples(count);
  for (PathResult& s : samples) {
    const auto any = [&](double scale) { return static_cast<float>(scale * random.normal()); };
    const double scale = std::ldexp(1.0, static_cast<int>(random.below(40)) - 20);
    s.radiance.x = any(scale), s.radiance.y = any(scale), s.radiance.z = any(scale);
    s.alpha = random.below(2) ? 1.0f : 0.3f;
    s.first.hit = random.below(3) > 0;
    s.first.position.x = any(100), s.first.position.y = any(1e-3);
    s.first.normal.z = any(1);
  }
  return samples;
}

PixelSum sum_of(const PathResult* samples, size_t count, const Camera& camera) {
  PixelSum sum;
  for (size_t i = 0; i < count; ++i) sum.add(samples[i], camera);
  return sum;
}

TEST(Film, AnySplitAndOrderGivesTheSameBits) {
  const CameraPtr camera = view({0, 0, 5}, {0, 0, 0}, 1.0);
  auto samples = some_samples(1000);
  const PixelSum whole = sum_of(samples.data(), samples.size(), *camera);
  RandomStream random(RandomKey(4).at("splits"));
  for (int trial = 0; trial < 50; ++trial) {
    for (size_t i = samples.size() - 1; i > 0; --i)
      std::swap(samples[i], samples[random.below(static_cast<uint32_t>(i + 1))]);
    const uint32_t first = random.below(1000), second = first + random.below(1000 - first);
    PixelSum joint = sum_of(samples.data() + second, samples.size() - second, *camera);
    joint.merge(sum_of(samples.data(), first, *camera));
    joint.merge(sum_of(samples.data() + first, second - first, *camera));
    ASSERT_TRUE(joint == whole) << first << " " << second;
  }
}

TEST(Film, UnitsHaveTheDocumentedPrecision) {
  for (const double v :
       {1.0, -1.0, 0.0, 0x1.fp-60, static_cast<double>(-7e-10f), 123456.789, 0x1p28, 0x1p-64})
    EXPECT_EQ(from_wide(to_wide(v, kLightBits), kLightBits), v) << v;
  EXPECT_EQ(to_wide(0x1p-65, kLightBits), 0);
  EXPECT_EQ(from_wide(to_wide(0x1p56, kSquareBits), kSquareBits), 0x1p56);
  // Sums of 2^20 of the brightest samples, and of their squares, do not overflow.
  EXPECT_GT(to_wide(kMaxLight, kLightBits) << 20, 0);
  EXPECT_GT(to_wide(kMaxLight * kMaxLight, kSquareBits) << 20, 0);
  EXPECT_LT(kMaxPlain * (1 << kPlainBits) * (1 << 20), 0x1p63);
}

TEST(Film, MeansAndVariancesAreThoseOfTheSamples) {
  const CameraPtr camera = view({0, 0, 5}, {0, 0, 0}, 1.0);
  RandomStream random(RandomKey(5).at("means"));
  PixelSum sum;
  std::vector<double> values;
  for (int i = 0; i < 500; ++i) {
    PathResult s;
    s.radiance = Rgb(static_cast<float>(3 + 0.1 * random.normal()));
    values.push_back(static_cast<double>(s.radiance.x));
    sum.add(s, *camera);
  }
  double mean = 0, spread = 0;
  for (const double v : values) mean += v / 500;
  for (const double v : values) spread += (v - mean) * (v - mean) / 499;
  EXPECT_NEAR(sum.mean(1), mean, 1e-14);
  EXPECT_NEAR(sum.variance(2), spread / 500, 1e-12 * spread);
}

TEST(Film, InvalidSamplesAreCountedAndDiscarded) {
  const CameraPtr camera = view({0, 0, 5}, {0, 0, 0}, 1.0);
  PathResult good, bad, bright;
  good.radiance = Rgb(2.0f);
  bad.radiance = {1, std::numeric_limits<float>::quiet_NaN(), 1};
  bright.radiance = Rgb(1e20f);
  PixelSum sum;
  sum.add(good, *camera), sum.add(bad, *camera), sum.add(good, *camera);
  EXPECT_EQ(sum.samples, 2u);
  EXPECT_EQ(sum.invalid, 1u);
  EXPECT_EQ(sum.mean(0), 2);
  sum.add(bright, *camera);
  EXPECT_EQ(sum.clamped, 1u);
  EXPECT_EQ(sum.samples, 3u);
}

// Renders of a lit floor with different seeds: the mean of the variance AOV equals the variance of
// the pixels between the pictures. With independent samples this is exact.
TEST(Film, VarianceIsThatOfRepeatedRenders) {
  Scene scene;
  scene.camera = view({0, 3, 2}, {0, 0, 0}, 0.9);
  scene.objects = {object(floor_mesh(4), 0.5)};
  scene.lights = {make_light("sphere", {{"center", Vec3d(1, 2, 0)}, {"radius", 0.8}}),
                  make_light("sky")};
  Options o = options(16, 12, 16, 2);
  o.sampler = make_sampler("independent");
  constexpr int kPictures = 64;
  std::vector<image::Image> pictures;
  for (int i = 0; i < kPictures; ++i) {
    o.seed = static_cast<uint64_t>(i);
    pictures.push_back(render(scene, o).select({"G", "variance.G", "samples"}));
  }
  double told = 0, seen = 0;
  for (size_t p = 0; p < pictures[0].pixel_count(); ++p) {
    double mean = 0;
    for (const auto& picture : pictures) {
      mean += static_cast<double>(picture.pixels[3 * p]) / kPictures;
      told += static_cast<double>(picture.pixels[3 * p + 1]) / kPictures;
      EXPECT_EQ(picture.pixels[3 * p + 2], 16);
    }
    for (const auto& picture : pictures) {
      const double d = static_cast<double>(picture.pixels[3 * p]) - mean;
      seen += d * d / (kPictures - 1);
    }
  }
  // 192 pixels with 63 degrees of freedom each: the ratio has an error of about 2 %.
  EXPECT_NEAR(told / seen, 1, 0.08);
}

}  // namespace
}  // namespace vug::render
