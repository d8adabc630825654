// SPDX-License-Identifier: Apache-2.0
// Haze against quadrature and furnaces.
#include "scenes.h"

#include <gtest/gtest.h>

namespace vug::render {
namespace {

MediumPtr haze(double extinction, double albedo, double g, const Vec3d& size) {
  return make_medium(
      "haze", {{"extinction", extinction}, {"albedo", Vec3d(albedo)}, {"g", g}, {"size", size}});
}

TEST(Haze, SlabAttenuatesTheSky) {
  Scene scene;
  scene.camera = view({0, 0, 5}, {0, 0, 0}, 1e-3);
  scene.lights = {make_light("sky")};
  scene.medium = haze(0.4, 0, 0, {50, 50, 2});
  const image::Image picture = render(scene, options(8, 8, 4, 8));
  EXPECT_NEAR(mean_of(picture, "G").value, std::exp(-0.8), 1e-5);
  EXPECT_NEAR(mean_of(picture, "A").value, 1 - std::exp(-0.8), 1e-5);
}

TEST(Haze, AtTheVisibilityTwoPercentOfTheContrastRemain) {
  Scene scene;
  scene.camera = view({0, 0, 30}, {0, 0, 0}, 1e-3);
  scene.lights = {make_light("sky")};
  scene.medium = make_medium(
      "haze", {{"visibility", 8.0}, {"albedo", Vec3d(0.0)}, {"size", Vec3d(50, 50, 8)}});
  EXPECT_NEAR(mean_of(render(scene, options(8, 8, 4, 8)), "G").value, 0.02, 1e-5);
}

TEST(Haze, WhiteHazeVanishesInAWhiteSky) {
  Scene scene;
  scene.camera = view({0, 0, 5}, {0, 0, 0}, 0.3);
  scene.lights = {make_light("sky")};
  for (const double g : {0.0, 0.8}) {
    scene.medium = haze(0.5, 1, g, {2, 2, 2});
    const Mean mean = mean_of(render(scene, options(32, 32, 64, 200)), "G");
    EXPECT_NEAR(mean.value, 1, 4 * mean.error) << g;
    EXPECT_LT(mean.error, 2e-3);
  }
}

// Single scattering of a small sphere's light into a ray, by Simpson's rule.
double single_scattering(double extinction, double g, double radius, double radiance, double height,
                         double reach) {
  const int n = 20000;
  double sum = 0;
  for (int i = 0; i <= n; ++i) {
    const double t = 2 * reach * i / n, x = t - reach;  // along the ray, from the foot
    const double d = std::sqrt(x * x + height * height);
    const double solid = 2 * kPi * (1 - std::sqrt(1 - radius * radius / (d * d)));
    const double cosine = -x / d;  // from the ray's direction to that of the light
    const double phase = (1 - g * g) / (4 * kPi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
    const double to_light = d - 2 * radius / 3;  // mean distance to the sphere's surface
    const double f = extinction * std::exp(-extinction * (t + to_light)) * phase * radiance * solid;
    sum += f * (i == 0 || i == n ? 1 : i % 2 ? 4 : 2);
  }
  return sum * 2 * reach / n / 3;
}

TEST(Haze, SingleScatteringMatchesQuadrature) {
  for (const double g : {0.0, 0.6})
    for (const double height : {0.1, 1.0}) {
      SCOPED_TRACE("g " + std::to_string(g) + " height " + std::to_string(height));
      Scene scene;
      scene.camera = view({0, 0, 3}, {0, 0, 0}, 1e-4);
      scene.lights = {make_light(
          "sphere", {{"center", Vec3d(0, height, 0)}, {"radius", 0.01}, {"radiance", Vec3d(1e4)}})};
      scene.medium = haze(0.2, 1, g, {6, 6, 6});
      const Mean mean = mean_of(render(scene, options(32, 32, 256, 0)), "G");
      const double expected = single_scattering(0.2, g, 0.01, 1e4, height, 3);
      EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-3 * expected);
      EXPECT_LT(mean.error, 4e-3 * expected);
    }
}

// A wall between light and ray keeps the haze dark there; multiple scattering stays finite.
TEST(Haze, ShadowsFallIntoTheHaze) {
  Scene scene;
  scene.camera = view({0, 0, 3}, {0, 0, 0}, 1e-4);
  scene.lights = {make_light("sphere", {{"center", Vec3d(0, 1, 0)}, {"radiance", Vec3d(10)}})};
  scene.medium = haze(0.2, 0.9, 0.3, {6, 6, 6});
  const double open = mean_of(render(scene, options(16, 16, 64, 0)), "G").value;
  Object wall = object(floor_mesh(30), 0);
  auto raised = std::make_shared<mesh::Mesh>(*wall.mesh);
  for (Vec3f& p : raised->positions) p.y = 0.5f;
  wall.mesh = raised;
  scene.objects = {wall};
  const double shut = mean_of(render(scene, options(16, 16, 64, 0)), "G").value;
  EXPECT_GT(open, 0);
  EXPECT_EQ(shut, 0);
}

// Without a box of its own, haze fills the scene's.
/// Another light that samples the sun's direction must not take light from it.
TEST(Haze, TheSunIsAsBrightWithPortals) {
  Scene scene;
  scene.camera = view({0, 0, 5}, {0, 0, 0}, 1e-3);
  scene.lights = {make_light("sky", {{"radiance", Vec3d(0.2)}}),
                  make_light("sun", {{"irradiance", Vec3d(5)}})};
  scene.medium = haze(0.4, 0.9, 0.3, {2, 2, 2});
  const Mean without_portals = mean_of(render(scene, options(32, 32, 64, 4)), "G");
  scene.lights.push_back(make_light("portal", {{"center", Vec3d(0, 4, 0)},
                                               {"normal", Vec3d(0, -1, 0)},
                                               {"width", 20.0},
                                               {"height", 20.0}}));
  const Mean with_portals = mean_of(render(scene, options(32, 32, 64, 4)), "G");
  EXPECT_LT(std::fabs(with_portals.value - without_portals.value),
            4 * std::hypot(without_portals.error, with_portals.error));
  EXPECT_LT(without_portals.error, 0.01 * without_portals.value);
  EXPECT_LT(with_portals.error, 3 * without_portals.error) << "by chance only";
}

TEST(Haze, FillsTheScene) {
  Scene scene;
  scene.camera = view({0, 0, 0}, {0, 0, -1}, 1e-3);
  scene.objects = {object(mesh::box_mesh({Vec3d(-2), Vec3d(2)}), 0)};
  scene.lights = {make_light("rect", {{"center", Vec3d(0, 0, -1.5)}, {"normal", Vec3d(0, 0, 1)}})};
  scene.medium = make_medium("haze", {{"extinction", 0.5}, {"albedo", Vec3d(0)}});
  EXPECT_NEAR(mean_of(render(scene, options(4, 4, 4, 2)), "R").value, std::exp(-0.75), 1e-5);
}

}  // namespace
}  // namespace vug::render
