// SPDX-License-Identifier: Apache-2.0
// A deep picture composited from front to back equals the picture.
#include <vug/base/rng.h>
#include <vug/render/film/deep.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

PathResult sample(bool hit, float alpha, const Rgb& light) {
  PathResult s;
  s.first.hit = hit, s.alpha = alpha, s.radiance = light;
  return s;
}

/// The composite of deep samples: R, G, B, A.
std::array<double, 4> flat(const std::vector<image::DeepSample>& samples) {
  image::DeepImage one(1, 1);
  one.at(0, 0) = samples;
  const image::Image picture = image::flatten(one);
  return {static_cast<double>(picture.pixels[0]), static_cast<double>(picture.pixels[1]),
          static_cast<double>(picture.pixels[2]), static_cast<double>(picture.pixels[3])};
}

TEST(Deep, CompositingGivesTheMeansOfAnySamples) {
  RandomStream random(RandomKey(7).at("deep"));
  const auto any = [&] { return random.uniform(); };
  for (int trial = 0; trial < 300; ++trial) {
    DeepOptions options;
    options.tolerance = trial % 3 == 0 ? 0 : 0.02;
    options.max_samples = 1 + random.below(20);
    DeepPixel pixel(options);
    const size_t count = 1 + random.below(80);
    double mean[4] = {0, 0, 0, 0};
    for (size_t i = 0; i < count; ++i) {
      const bool hit = any() < 0.8;
      // In front of the sky there may be fog or nothing.
      const auto alpha = static_cast<float>(hit ? 1 : any() < 0.5 ? 0 : any());
      const Rgb light(static_cast<float>(any()), static_cast<float>(9 * any()), 0.5f);
      mean[0] += static_cast<double>(light.x), mean[1] += static_cast<double>(light.y);
      mean[2] += 0.5, mean[3] += static_cast<double>(alpha);
      pixel.add(sample(hit, alpha, light), 1 + std::floor(6 * any()) + 0.01 * any());
    }
    const std::vector<image::DeepSample> samples = pixel.finish();
    ASSERT_LE(samples.size(), options.max_samples);
    for (size_t i = 0; i < samples.size(); ++i) {
      ASSERT_LE(samples[i].near, samples[i].far);
      ASSERT_GE(samples[i].alpha, 0);
      ASSERT_LE(samples[i].alpha, 1);
      if (i > 0) {
        ASSERT_GT(samples[i].near, samples[i - 1].far);
      }
    }
    const auto got = flat(samples);
    for (size_t c = 0; c < 4; ++c)
      ASSERT_NEAR(got[c], mean[c] / static_cast<double>(count),
                  1e-5 * (1 + mean[c] / static_cast<double>(count)))
          << trial;
  }
}

TEST(Deep, SurfacesOfEqualDepthAreMerged) {
  DeepPixel pixel({});
  for (int i = 0; i < 10; ++i) pixel.add(sample(true, 1, Rgb(1.0f)), i < 6 ? 2 + 0.001 * i : 5);
  const auto samples = pixel.finish();
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_FLOAT_EQ(samples[0].near, 2);
  EXPECT_FLOAT_EQ(samples[0].far, 2.005f);
  EXPECT_FLOAT_EQ(samples[0].alpha, 0.6f);  // relative to the pixel
  EXPECT_FLOAT_EQ(samples[1].near, 5);
  EXPECT_FLOAT_EQ(samples[1].alpha, 1);  // relative to the remaining visibility
  EXPECT_TRUE(pixel.finish().empty());
}

TEST(Deep, InvalidSamplesAreDiscarded) {
  DeepPixel pixel({});
  pixel.add(sample(true, 1, Rgb(std::numeric_limits<float>::quiet_NaN())), 1);
  pixel.add(sample(true, 1, Rgb(0.5f)), 1);
  EXPECT_NEAR(flat(pixel.finish())[0], 0.5, 1e-6);
}

TEST(Deep, DeepRenderCompositesToTheBeauty) {
  Scene scene;
  scene.camera = view({0, 1.5, 4}, {0, 0.5, 0}, 1.1);
  scene.objects = {object(floor_mesh(1.5), 0.5)};
  Object ball = object(mesh::sphere_mesh({0.3, 0.5, 0.8}, 0.5, 3), 0.7);
  scene.objects.push_back(ball);
  scene.lights = {make_light("sphere", {{"center", Vec3d(0.8, 1.4, 0)}, {"radius", 0.2}}),
                  make_light("sky", {{"radiance", Vec3d(0.1, 0.2, 0.3)}})};
  scene.medium = make_medium("haze", {{"extinction", 0.1}});
  Options o = options(40, 30, 16, 2);
  o.deep.emplace();
  o.crop = {5, 4, 37, 29};
  image::DeepImage deep, again;
  const image::Image picture = render(scene, o, Progress::none(), {}, &deep);
  const image::Image composited = image::flatten(deep);
  size_t edges = 0;
  for (size_t p = 0; p < picture.pixel_count(); ++p) {
    edges += deep.pixels[p].size() > 1;
    for (const char* c : {"R", "G", "B", "A"}) {
      const float ours =
          picture
              .pixels[p * picture.channels.size() + static_cast<size_t>(picture.find_channel(c))];
      const float theirs =
          composited.pixels[4 * p + static_cast<size_t>(composited.find_channel(c))];
      ASSERT_NEAR(theirs, ours, 1e-5f * (1 + ours)) << p << c;
    }
  }
  EXPECT_GT(edges, 60u);
  o.threads = 3;
  o.tile_size = 7;
  render(scene, o, Progress::none(), {}, &again);
  EXPECT_EQ(again.pixels, deep.pixels);
  o.deep.reset(), o.threads = 0, o.tile_size = 16;
  EXPECT_EQ(render(scene, o), picture);
}

}  // namespace
}  // namespace vug::render
