// SPDX-License-Identifier: Apache-2.0
// A deep picture composited from front to back equals the picture.
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/render/film/deep.h>
#include <vug/render/film/render_state.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

DeepFragment fragment(double depth, float alpha, const Rgb& light) {
  return {0, static_cast<float>(depth), alpha, light.x, light.y, light.z};
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
    std::vector<DeepFragment> pixel;
    const size_t count = 1 + random.below(80);
    double mean[4] = {0, 0, 0, 0};
    for (size_t i = 0; i < count; ++i) {
      const bool hit = any() < 0.8;
      // In front of the sky there may be fog or nothing.
      const auto alpha = static_cast<float>(hit ? 1 : any() < 0.5 ? 0 : any());
      const Rgb light(static_cast<float>(any()), static_cast<float>(9 * any()), 0.5f);
      mean[0] += static_cast<double>(light.x), mean[1] += static_cast<double>(light.y);
      mean[2] += 0.5, mean[3] += static_cast<double>(alpha);
      const double depth = 1 + std::floor(6 * any()) + 0.01 * any();
      pixel.push_back(fragment(hit ? depth : static_cast<double>(kDeepSky), alpha, light));
    }
    const std::vector<image::DeepSample> samples = merge_fragments(pixel, options);
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
  std::vector<DeepFragment> pixel;
  for (int i = 0; i < 10; ++i) pixel.push_back(fragment(i < 6 ? 2 + 0.001 * i : 5, 1, Rgb(1.0f)));
  const auto samples = merge_fragments(pixel, {});
  ASSERT_EQ(samples.size(), 2u);
  EXPECT_FLOAT_EQ(samples[0].near, 2);
  EXPECT_FLOAT_EQ(samples[0].far, 2.005f);
  EXPECT_FLOAT_EQ(samples[0].alpha, 0.6f);  // relative to the pixel
  EXPECT_FLOAT_EQ(samples[1].near, 5);
  EXPECT_FLOAT_EQ(samples[1].alpha, 1);  // relative to the remaining visibility
  EXPECT_TRUE(merge_fragments({}, {}).empty());
}

TEST(Deep, FilmsKeepValidSamplesInTheOrderOfTheirIndices) {
  const CameraPtr camera = view({0, 0, 4}, {0, 0, 0}, 1);
  const Region pixel{0, 0, 1, 1};
  const auto film = [&](std::initializer_list<uint32_t> indices) {
    Film out(pixel, {.deep = true});
    for (const uint32_t index : indices) {
      PathResult sample;
      sample.first.hit = index != 4, sample.alpha = 1;
      sample.radiance = Rgb(index == 2 ? std::numeric_limits<float>::quiet_NaN() : 0.5f);
      out.add(0, 0, index, sample, *camera, nullptr);
    }
    return out;
  };
  Film joint(pixel, {.deep = true});
  for (const Film& part : {film({3, 4, 5}), film({6}), film({0, 1, 2})}) joint.merge(part);
  const std::vector<DeepFragment> expected = film({0, 1, 2, 3, 4, 5, 6}).fragments(0, 0);
  ASSERT_EQ(expected.size(), 6u);
  EXPECT_EQ(joint.fragments(0, 0), expected);
  EXPECT_EQ(expected[3].sample, 4u);
  EXPECT_EQ(expected[3].depth, kDeepSky);
  EXPECT_FLOAT_EQ(expected[0].depth, 4);
}

/// A ball over the edge of a floor in haze, as a deep picture.
Scene ball_in_haze() {
  Scene scene;
  scene.camera = view({0, 1.5, 4}, {0, 0.5, 0}, 1.1);
  scene.objects = {object(floor_mesh(1.5), 0.5)};
  scene.objects.push_back(object(mesh::sphere_mesh({0.3, 0.5, 0.8}, 0.5, 3), 0.7));
  scene.lights = {make_light("sphere", {{"center", Vec3d(0.8, 1.4, 0)}, {"radius", 0.2}}),
                  make_light("sky", {{"radiance", Vec3d(0.1, 0.2, 0.3)}})};
  scene.medium = make_medium("haze", {{"extinction", 0.1}});
  return scene;
}

TEST(Deep, DeepRenderCompositesToTheBeauty) {
  const Scene scene = ball_in_haze();
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

Options deep_options(int spp) {
  Options o = options(40, 30, spp, 2);
  o.aovs = plan_aovs({"all"}, {});
  o.deep.emplace().tolerance = 0.02;
  return o;
}

TEST(Deep, SlicesHaveTheBytesOfTheWhole) {
  const Scene scene = ball_in_haze();
  Options o = deep_options(12);
  image::DeepImage whole;
  const image::Image picture = render(scene, o, Progress::none(), {}, &whole);
  for (const int threads : {1, 2, 5, 8}) {
    o.threads = threads;
    RenderState joint = begin_render(o);
    for (const int band : {2, 0, 1})
      for (const auto& [begin, end] : {std::pair(7u, 12u), {0u, 3u}, {3u, 7u}}) {
        RenderState state = begin_render(o, {band, 3, begin, end});
        continue_render(scene, o, state, {}, Progress::none());
        joint.film.merge(state.film);
      }
    EXPECT_EQ(develop(joint, *o.deep).pixels, whole.pixels) << threads;
    EXPECT_EQ(develop(joint, o.aovs), picture) << threads;
  }
}

TEST(Deep, PassesAndSavesKeepTheBytes) {
  const Scene scene = ball_in_haze();
  const Options o = deep_options(20);
  image::DeepImage whole, again;
  const image::Image picture = render(scene, o, Progress::none(), {}, &whole);
  RenderCallbacks callbacks;
  int passes = 0, saves = 0;
  callbacks.save_every = 0;
  callbacks.pass = [&](const RenderState& state) { passes += !state.complete(); };
  callbacks.save = [&](const RenderState&) { ++saves; };
  EXPECT_EQ(render(scene, o, Progress::none(), callbacks, &again), picture);
  EXPECT_EQ(again.pixels, whole.pixels);
  EXPECT_EQ(passes, 3);
  EXPECT_GT(saves, 3);
}

TEST(Deep, CancelledRendersCanBeResumed) {
  const Scene scene = ball_in_haze();
  const Options o = deep_options(20);
  image::DeepImage whole;
  render(scene, o, Progress::none(), {}, &whole);
  for (const int stop : {1, 4}) {
    RenderState state = begin_render(o), kept;
    Progress progress;
    int saves = 0;
    RenderCallbacks callbacks;
    callbacks.save_every = 0;
    callbacks.save = [&](const RenderState& now) {
      if (progress.cancelled()) return;
      kept = now;
      if (++saves == stop) progress.cancel();
    };
    EXPECT_THROW(continue_render(scene, o, state, callbacks, progress), Error);
    EXPECT_GT(kept.fraction(), 0);
    EXPECT_LT(kept.fraction(), 1);
    continue_render(scene, o, kept, {}, Progress::none());
    EXPECT_EQ(develop(kept, *o.deep).pixels, whole.pixels);
  }
}

TEST(Deep, AdaptiveSamplingKeepsTheCompositeEqualToTheBeauty) {
  const Scene scene = ball_in_haze();
  Options o = deep_options(256);
  o.noise = 0.1;
  image::DeepImage deep;
  const image::Image picture = render(scene, o, Progress::none(), {}, &deep);
  const auto samples = static_cast<size_t>(picture.find_channel("samples"));
  const auto red = static_cast<size_t>(picture.find_channel("R"));
  const image::Image composited = image::flatten(deep);
  float fewest = 256;
  for (size_t p = 0; p < picture.pixel_count(); ++p) {
    const float* pixel = &picture.pixels[p * picture.channels.size()];
    fewest = std::min(fewest, pixel[samples]);
    ASSERT_NEAR(composited.pixels[4 * p], pixel[red], 1e-5f * (1 + pixel[red])) << p;
  }
  EXPECT_LT(fewest, 256);
}

TEST(Deep, TheMemoryEstimateCountsTheSamples) {
  const Options few = deep_options(16), many = deep_options(1016);
  const double pixels = 40 * 30;
  EXPECT_GE(memory_estimate({}, many, true) - memory_estimate({}, few, true), 24e3 * pixels);
  Options flat = many;
  flat.deep.reset();
  EXPECT_LT(memory_estimate({}, flat, true), 0.1 * memory_estimate({}, many, true));
}

}  // namespace
}  // namespace vug::render
