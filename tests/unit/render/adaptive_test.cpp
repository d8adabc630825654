// SPDX-License-Identifier: Apache-2.0
// Adaptive sampling: as bright as sampling everything, with less work.
#include <vug/image/brightness.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

/// A dark hall with a light at one end behind the edge of a wall, so that the noise varies over the
/// picture and much of the light is indirect.
Scene hall() {
  Scene scene;
  scene.camera = view({-3, 1.2, 0}, {3, 0.8, 0}, 1.2);
  mesh::Mesh wall = floor_mesh(4);
  for (Vec3f& p : wall.positions) p = {p.x, p.z + 2, -2};
  mesh::Mesh screen = floor_mesh(1);
  for (Vec3f& p : screen.positions) p = {1, p.z + 0.5f, p.x - 1.2f};
  scene.objects = {object(floor_mesh(5), 0.6), object(wall, 0.7), object(screen, 0.5)};
  scene.lights = {make_light(
      "sphere", {{"center", Vec3d(2, 0.6, -1)}, {"radius", 0.1}, {"radiance", Vec3d(40.0)}})};
  return scene;
}

TEST(Adaptive, MeanIsThatOfAllSamplesWithLessWork) {
  const Scene scene = hall();
  double difference = 0, squares = 0, light = 0, taken = 0;
  constexpr int kPictures = 20;
  for (int i = 0; i < kPictures; ++i) {
    Options o = options(48, 32, 256, 3);
    o.seed = static_cast<uint64_t>(i);
    o.noise = 0.25;
    const image::Image few = render(scene, o);
    o.seed += 1000;
    o.noise = 0;
    o.spp = 64;
    const image::Image all = render(scene, o);
    const double d = mean_of(few, "G").value - mean_of(all, "G").value;
    difference += d, squares += d * d;
    light += mean_of(all, "G").value;
    taken += mean_of(few, "samples").value;
  }
  // The mean of the differences is compared with their own spread, which is small.
  const double n = kPictures, mean = difference / n;
  const double error = std::sqrt((squares / n - mean * mean) / (n - 1));
  EXPECT_LT(std::fabs(mean), 3.5 * error);
  EXPECT_LT(error, 0.003 * light / n);
  EXPECT_LT(taken / n, 160);
  EXPECT_GE(taken / n, 16);
}

TEST(Adaptive, NoiseIsTheRequestedOne) {
  Options o = options(112, 80, 1 << 13, 3);
  o.noise = 0.25;
  const image::Image picture = render(hall(), o);
  // The log-average of pixels; the criterion uses that of tiles, which is nearly the same.
  const double key = 0.18 / std::exp2(image::grey_exposure(picture).value());
  double squares = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      const auto at = [&](const char* c) {
        return static_cast<double>(picture.at(x, y, static_cast<size_t>(picture.find_channel(c))));
      };
      const double light = at("G") + 0.25 * key;  // grey walls, white light: all channels are equal
      squares += at("variance.G") / (light * light);
    }
  const double noise = std::sqrt(squares / static_cast<double>(picture.pixel_count()));
  EXPECT_LT(noise, 1.2 * o.noise);
  EXPECT_GT(noise, 0.4 * o.noise);
  // Samples are taken where the noise is: some tiles have many times more than others.
  float least = 1e9f, most = 0;
  const auto samples = picture.select({"samples"});
  for (const float n : samples.pixels) least = std::min(least, n), most = std::max(most, n);
  EXPECT_GE(least, 16);
  EXPECT_GE(most, 4 * least);
  EXPECT_LT(most, 1 << 13);
}

TEST(Adaptive, TheReportsPredictTheWorkAndStateTheNoise) {
  Options o = options(64, 48, 1 << 12, 3);
  o.noise = 0.2;
  std::vector<NoiseReport> reports;
  std::vector<double> seconds;
  RenderCallbacks callbacks;
  callbacks.noise = [&](const NoiseReport& report, double left) {
    reports.push_back(report), seconds.push_back(left);
  };
  const image::Image picture = render(hall(), o, Progress::none(), callbacks);
  ASSERT_GE(reports.size(), 3u);
  const NoiseReport& last = reports.back();
  EXPECT_EQ(last.missing, 0);
  EXPECT_EQ(seconds.back(), 0);
  EXPECT_LT(last.noise, o.noise);  // each block has it, and some are better
  EXPECT_GT(last.noise, 0.3 * o.noise);
  EXPECT_NEAR(last.samples, mean_of(picture, "samples").value, 1e-3 * last.samples);
  const auto pixels = static_cast<double>(picture.pixel_count());
  for (size_t i = 0; i + 1 < reports.size(); ++i) {
    EXPECT_LT(reports[i].samples, reports[i + 1].samples);
    EXPECT_GT(reports[i].noise, reports[i + 1].noise);
    EXPECT_GT(seconds[i], 0);
    const double expected = reports[i].samples + reports[i].missing / pixels;
    // The first samples of a dim hall lack most of its bright paths.
    const double factor = i + 3 < reports.size() ? 6 : 2;
    EXPECT_LT(expected, factor * last.samples) << i;
    EXPECT_GT(expected, last.samples / factor) << i;
  }
}

TEST(Adaptive, WithoutALimitNothingIsReported) {
  Options o = options(16, 16, 32, 2);
  RenderCallbacks callbacks;
  callbacks.noise = [](const NoiseReport&, double) { ADD_FAILURE(); };
  callbacks.pass = [](const RenderState&) {};
  render(hall(), o, Progress::none(), callbacks);
}

TEST(Adaptive, ThreadsDoNotMatter) {
  Options o = options(70, 50, 128, 2);
  o.noise = 0.08;
  o.threads = 1;
  const image::Image one = render(hall(), o);
  for (const int threads : {2, 5, 8}) {
    o.threads = threads;
    EXPECT_EQ(render(hall(), o), one) << threads;
  }
}

}  // namespace
}  // namespace vug::render
