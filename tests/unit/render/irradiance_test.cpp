// SPDX-License-Identifier: Apache-2.0
// Direct light on a white floor against closed forms: radiance = irradiance / pi.
#include "scenes.h"

#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace vug::render {
namespace {

/// Radiance of the floor at the origin, seen from the side so that the camera sees no light
/// directly.
Mean lit(const std::vector<LightPtr>& lights, int spp = 256) {
  Scene scene;
  scene.camera = view({0.4, 0.3, 0}, {0, 0, 0}, 1e-3);
  scene.objects = {object(floor_mesh(2), 1)};
  scene.lights = lights;
  return mean_of(render(scene, options(32, 32, spp, 0)), "G");
}

void expect_radiance(const Mean& mean, double expected) {
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-4 * expected);
  EXPECT_LT(mean.error, 2e-3 * expected);
}

LightPtr ceiling(double height, double width, double depth, const Vec3d& shift) {
  return make_light("rect", {{"center", shift + Vec3d(0, height, 0)},
                             {"normal", Vec3d(0, -1, 0)},
                             {"width", width},
                             {"height", depth},
                             {"radiance", Vec3d(2)},
                             {"visible", false}});
}

/// Form factor of a rectangle with one corner above the point (Howell, C-3).
double corner_form_factor(double a, double b, double height) {
  const double x = a / height, y = b / height;
  const double p = std::sqrt(1 + x * x), q = std::sqrt(1 + y * y);
  return (x / p * std::atan(y / p) + y / q * std::atan(x / q)) / (2 * kPi);
}

TEST(Irradiance, RectangleOverThePoint) {
  for (const double height : {0.05, 0.5, 1.0, 30.0}) {
    SCOPED_TRACE(height);
    expect_radiance(lit({ceiling(height, 0.8, 0.6, {0, 0, 0})}),
                    2 * 4 * corner_form_factor(0.4, 0.3, height));
  }
}

TEST(Irradiance, RectangleWithACornerOverThePoint) {
  // The width runs along +-x, the depth along +-z.
  expect_radiance(lit({ceiling(0.7, 0.8, 0.6, {0.4, 0, 0.3})}, 1024),
                  2 * corner_form_factor(0.8, 0.6, 0.7));
}

TEST(Irradiance, RectangleThatCrossesTheHorizon) {
  // Upright, half of it below the floor: the upper half counts (Howell, C-4).
  const double d = 0.5, half = 0.6, height = 0.4;
  const LightPtr wall = make_light("rect", {{"center", Vec3d(-d, 0, 0)},
                                            {"normal", Vec3d(1, 0, 0)},
                                            {"up", Vec3d(0, 1, 0)},
                                            {"width", 2 * half},
                                            {"height", 2 * height},
                                            {"radiance", Vec3d(2)},
                                            {"visible", false}});
  const double r = std::sqrt(height * height + d * d);
  const double factor = (std::atan(half / d) - d / r * std::atan(half / r)) / kPi;
  expect_radiance(lit({wall}, 1024), 2 * factor);
}

TEST(Irradiance, BehindARectangleIsDark) {
  const LightPtr up = make_light("rect", {{"center", Vec3d(0, 1, 0)}, {"normal", Vec3d(0, 1, 0)}});
  EXPECT_EQ(lit({up}, 4).value, 0);
}

TEST(Irradiance, SphereAboveTheHorizon) {
  for (const double radius : {0.01, 0.5}) {
    SCOPED_TRACE(radius);
    const Vec3d center(0.6, 0.9, -0.2);
    const LightPtr ball = make_light(
        "sphere",
        {{"center", center}, {"radius", radius}, {"radiance", Vec3d(3)}, {"visible", false}});
    const double d2 = center.length2();
    expect_radiance(lit({ball}), 3 * radius * radius / d2 * (0.9 / std::sqrt(d2)));
  }
}

TEST(Irradiance, ManyLightsAddUp) {
  std::vector<LightPtr> lights;
  double expected = 0;
  for (int i = 0; i < 12; ++i) {
    const Vec3d center(-1.1 + 0.2 * i, 0.5 + 0.3 * (i % 4), 0.1 * i);
    lights.push_back(make_light("sphere", {{"center", center},
                                           {"radius", 0.02 + 0.01 * (i % 3)},
                                           {"radiance", Vec3d(1 + i % 5)},
                                           {"visible", false}}));
    const double r = 0.02 + 0.01 * (i % 3), d2 = center.length2();
    expected += (1 + i % 5) * r * r / d2 * center.y / std::sqrt(d2);
  }
  expect_radiance(lit(lights, 1024), expected);
}

TEST(Irradiance, SkiesLightTheFloorUniformly) {
  expect_radiance(lit({make_light("sky", {{"radiance", Vec3d(2)}})}, 16), 2);
  const ScratchFolder scratch("vug_sky");
  const auto file = scratch.file("even.exr");
  image::Image even(16, 8, {"R", "G", "B"});
  for (float& v : even.pixels) v = 2;
  image::write_exr(file, even);
  expect_radiance(lit({make_light("sky_image", {{"file", file.string()}})}), 2);
}

TEST(Irradiance, SkyImageHasTheRightOrientation) {
  // Light only from straight up: that of a cap of the same size.
  const ScratchFolder scratch("vug_sky");
  const auto file = scratch.file("spot.exr");
  image::Image sky(64, 32, {"R", "G", "B"});
  sky.at(48, 12, 1) = 100;  // a quarter turn right of the middle (-z), so towards +x
  image::write_exr(file, sky);
  const LightPtr light = make_light("sky_image", {{"file", file.string()}});
  const double polar = kPi * 12.5 / 32, turn = kPi / 2 + kPi / 64;
  const Vec3f towards(static_cast<float>(std::sin(polar) * std::sin(turn)),
                      static_cast<float>(std::cos(polar)),
                      static_cast<float>(-std::sin(polar) * std::cos(turn)));
  EXPECT_NEAR(light->eval_environment(towards).y, 100, 1e-2);
  EXPECT_EQ(light->eval_environment({0, -1, 0}).y, 0);
  const LightPtr turned =
      make_light("sky_image", {{"file", file.string()}, {"turn", radians(kPi / 2)}});
  // Turned left by 90 degrees as seen from above: +x becomes -z.
  EXPECT_NEAR(turned->eval_environment({towards.z, towards.y, -towards.x}).y, 100, 1e-1);
  // Interpolation spreads a texel as a pyramid over its neighbours: sin cos = sin(2 a) / 2 times a
  // pyramid of half width w integrates to the central value times sinc^2(w).
  const double w = kPi / 32, texel = (2 * kPi / 64) * w;
  const double pyramid = std::pow(std::sin(w) / w, 2);
  expect_radiance(lit({light}, 1024),
                  100 * texel * std::sin(polar) * std::cos(polar) * pyramid / kPi);
}

/// Lambert's formula for the irradiance of a polygon above the horizon, by its edges.
double irradiance(const std::vector<Vec3d>& corners, const Vec3d& normal) {
  double sum = 0;
  for (size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = corners[i].normalized(), b = corners[(i + 1) % corners.size()].normalized();
    const Vec3d edge = a.cross(b);
    sum += std::atan2(edge.length(), a.dot(b)) * edge.normalized().dot(normal);
  }
  return std::fabs(sum) / 2;
}

/// A few thousand small triangles below a ceiling, sampled by the tree, against the exact sum.
TEST(Irradiance, OfManyTrianglesIsExactWithLittleNoise) {
  RandomStream random{RandomKey(17)};
  mesh::Mesh mesh;
  double exact = 0;
  for (uint32_t i = 0; i < 3000; ++i) {
    const double x = random.uniform(-3, 3), z = random.uniform(-3, 3),
                 r = random.uniform(0.01, 0.04);
    const std::vector<Vec3d> corners = {{x, 1, z}, {x + r, 1, z}, {x, 1, z + r}};
    for (const Vec3d& corner : corners) mesh.positions.push_back(Vec3f(corner));
    mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    exact += irradiance(corners, {0, 1, 0});
  }
  Scene scene;
  scene.objects.push_back(object(floor_mesh(5), 0.5));
  scene.objects.push_back(object(std::move(mesh), 0));
  scene.objects.back().emission = Rgb(1);
  scene.camera = view({4, 0.9, 0}, {0, 0, 0}, 0.001);
  const image::Image picture = render(scene, options(48, 48, 16, 0));
  const Mean mean = mean_of(picture, "G");
  EXPECT_NEAR(mean.value, 0.5 / kPi * exact, 4 * mean.error);
  // Of one sample, relative to the mean.
  const double noise = mean.error * 48 * std::sqrt(16.0) / mean.value;
  EXPECT_LT(noise, 0.08);  // 0.17 without resampling of candidates, 0.05 with it
}

}  // namespace
}  // namespace vug::render
