// SPDX-License-Identifier: Apache-2.0
// The denoiser on a rendered picture: closer to the converged picture, with edges and means kept.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/image/denoise.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

/// A checkered floor in front of a wall, lit directly and indirectly.
Scene checkers() {
  Scene scene;
  scene.camera = view({0, 1.5, 3.5}, {0, 0.5, 0}, 1.1);
  mesh::Mesh floor;
  std::vector<float> colours;
  for (int i = 0; i < 64; ++i) {
    const auto x = static_cast<float>(i % 8 - 4), z = static_cast<float>(i / 8 - 4);
    const auto first = static_cast<uint32_t>(floor.positions.size());
    for (const Vec3f& p :
         {Vec3f(x, 0, z), Vec3f(x, 0, z + 1), Vec3f(x + 1, 0, z + 1), Vec3f(x + 1, 0, z)}) {
      floor.positions.push_back(p);
      colours.insert(colours.end(), 3, (i + i / 8) % 2 ? 0.2f : 1.0f);
    }
    floor.triangles.push_back({first, first + 1, first + 2});
    floor.triangles.push_back({first, first + 2, first + 3});
  }
  floor.attributes.push_back({"Cd", 3, colours});
  mesh::Mesh wall = floor_mesh(4);
  for (Vec3f& p : wall.positions) p = {p.x, p.z, -1.5f};
  scene.objects = {object(floor, 0.7), object(wall, 0.6)};
  scene.lights = {make_light("sphere", {{"center", Vec3d(1.2, 1.6, -0.5)},
                                        {"radius", 0.15},
                                        {"radiance", Vec3d(12, 9, 6)},
                                        {"visible", false}}),
                  make_light("sky", {{"radiance", Vec3d(0.05, 0.07, 0.1)}})};
  return scene;
}

double squared_error(const image::Image& a, const image::Image& b) {
  double sum = 0;
  for (size_t i = 0; i < a.pixels.size(); ++i) {
    const auto d = static_cast<double>(a.pixels[i] - b.pixels[i]);
    sum += d * d;
  }
  return sum / static_cast<double>(a.pixels.size());
}

TEST(Denoise, SixteenSamplesGetCloserToTheReference) {
  Options o = options(60, 40, 4096, 3);
  o.sampler = make_sampler("independent");
  const std::vector<std::string> rgb = {"R", "G", "B"};
  const image::Image reference = render(checkers(), o).select(rgb);
  o.spp = 16, o.seed = 7;
  const image::Image noisy = render(checkers(), o);
  const image::Image smooth = image::denoise(noisy);
  const double before = squared_error(noisy.select(rgb), reference);
  const double after = squared_error(smooth, reference);
  const double gain = std::sqrt(before / after);
  RecordProperty("gain_in_rmse", std::to_string(gain));
  EXPECT_GT(gain, 1.73) << "equivalent to at least three times the samples";
  // Smoothing redistributes light and hardly removes any.
  EXPECT_NEAR(mean_of(smooth, "denoised.G").value, mean_of(noisy, "G").value,
              0.02 * mean_of(noisy, "G").value);
}

TEST(Denoise, ThreadsDoNotMatter) {
  const image::Image noisy = render(checkers(), options(75, 70, 4, 1));
  const image::Image first = image::denoise(noisy);
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] { EXPECT_EQ(image::denoise(noisy), first) << threads; });
  }
}

TEST(Denoise, WithoutNoiseNothingIsSmoothed) {
  image::Image picture(20, 10, {"R", "G", "B", "variance.R", "variance.G", "variance.B"});
  for (int y = 0; y < 10; ++y)
    for (int x = 0; x < 20; ++x)
      for (size_t c = 0; c < 3; ++c) picture.at(x, y, c) = x < 10 ? 0.2f : 0.8f;
  const image::Image smooth = image::denoise(picture);
  for (int x = 0; x < 20; ++x) EXPECT_NEAR(smooth.at(x, 5, 0), x < 10 ? 0.2f : 0.8f, 1e-5f);
  EXPECT_THROW(image::denoise(picture.select({"R", "G", "B"})), Error);
}

}  // namespace
}  // namespace vug::render
