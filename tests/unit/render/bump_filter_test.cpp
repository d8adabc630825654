// SPDX-License-Identifier: Apache-2.0
// Bumps that a pixel does not resolve look like the same bumps from nearby, averaged.
#include "scenes.h"

#include <vug/base/maths.h>
#include <vug/paint/kind.h>
#include <vug/render/lobes/microfacet.h>
#include <vug/render/materials/material_input.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

/// A dozen waves of about 2 cm in all directions, whose slopes are nearly normally distributed,
/// under a film of water; lit by a lamp.
Scene bumpy_floor(double height) {
  const auto waves = paint::make_mask([](const paint::EvalPoint& point) {
    double sum = 0.5;
    for (int i = 0; i < 12; ++i) {
      const double angle = kPi * (i + 0.3) / 12, turn = 2 * kPi / (0.016 + 0.001 * (i * 5 % 12));
      sum += 0.04 * maths::sin(turn * (maths::cos(angle) * point.position.x +
                                       maths::sin(angle) * point.position.z) +
                               2.4 * i);
    }
    return sum;
  });
  Scene scene;
  scene.objects.push_back(object(floor_mesh(3), 0.3));
  scene.objects[0].material =
      make_material("surface", {{"color", Vec3d(0.05)},
                                {"coat", 1.0},
                                {"coat_roughness", 0.15},
                                {"bump", ValueTraits<paint::Mask>::write(waves)},
                                {"bump_height", Number{height, Dimension::length}}});
  scene.lights.push_back(make_light(
      "sphere",
      {{"center", Vec3d(0, 2, -2)}, {"radius", 0.2}, {"radiance", Vec3d(50)}, {"visible", false}}));
  scene.camera = view({0, 2, 2}, {0, 0, 0}, 0.4);
  return scene;
}

image::Image floor_picture(const Scene& scene, int scale, int spp, int threads = 0) {
  Options o = options(12 * scale, 8 * scale, spp, 0);
  o.threads = threads;
  return render(scene, o);
}

/// The picture at the lower resolution.
std::vector<double> averaged(const image::Image& fine, int scale) {
  std::vector<double> out(12 * 8);
  for (int y = 0; y < fine.height; ++y)
    for (int x = 0; x < fine.width; ++x)
      out[static_cast<size_t>(y / scale * 12 + x / scale)] +=
          static_cast<double>(fine.at(x, y, 1)) / (scale * scale);
  return out;
}

TEST(BumpFilter, DistantBumpsLookLikeTheAverageOfNearOnes) {
  constexpr int kScale = 40;  // a pixel of the large picture covers 3 mm
  const Scene scene = bumpy_floor(0.008);
  const std::vector<double> expected = averaged(floor_picture(scene, kScale, 4), kScale);
  const image::Image far = floor_picture(scene, 1, 1024);
  const image::Image flat = floor_picture(bumpy_floor(0), 1, 1024);
  double error = 0, flat_error = 0, squares = 0, sum = 0, expected_sum = 0;
  for (size_t p = 0; p < expected.size(); ++p) {
    const auto seen = static_cast<double>(far.pixels[far.channels.size() * p + 1]);
    const auto smooth = static_cast<double>(flat.pixels[flat.channels.size() * p + 1]);
    error += (seen - expected[p]) * (seen - expected[p]);
    flat_error += (smooth - expected[p]) * (smooth - expected[p]);
    squares += expected[p] * expected[p];
    sum += seen, expected_sum += expected[p];
  }
  RecordProperty("relative_rmse", std::to_string(std::sqrt(error / squares)));
  RecordProperty("relative_rmse_of_a_smooth_film", std::to_string(std::sqrt(flat_error / squares)));
  EXPECT_LT(std::sqrt(error / squares), 0.3);
  EXPECT_GT(std::sqrt(flat_error / squares), 3) << "the bumps matter";
  EXPECT_NEAR(sum / expected_sum, 1, 0.1);
}

TEST(BumpFilter, AddsTheSquaredWidthsUpToALimit) {
  EXPECT_EQ(filtered_roughness(0.2f, 0), 0.2f);
  EXPECT_NEAR(filtered_roughness(0.2f, 0.02f), std::pow(0.0016 + 0.04, 0.25), 1e-6);
  EXPECT_EQ(filtered_roughness(0.2f, 1), filtered_roughness(0.2f, 0.09f));
  EXPECT_LE(filtered_roughness(0.95f, 1), 1.0f);
}

TEST(BumpFilter, HasTheSameBytesForAnyNumberOfThreads) {
  const Scene scene = bumpy_floor(0.008);
  const image::Image one = floor_picture(scene, 2, 4, 1);
  EXPECT_EQ(one, floor_picture(scene, 2, 4, 2));
  EXPECT_EQ(one, floor_picture(scene, 2, 4, 7));
}

}  // namespace
}  // namespace vug::render
