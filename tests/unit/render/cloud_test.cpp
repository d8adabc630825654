// SPDX-License-Identifier: Apache-2.0
// Clouds against haze, quadrature and furnaces.
#include "scenes.h"

#include <gtest/gtest.h>
#include <vug/base/rng.h>
#include <vug/field/registry.h>
#include <vug/volume/density.h>
#include <vug/volume/fog.h>
#include <vug/volume/voxelize.h>

namespace vug::render {
namespace {

/// A ball of radius 1 m: density 1 inside, falling to 0 over its outer 30 cm.
std::shared_ptr<const volume::Density> ball() {
  static const auto density = [] {
    volume::VoxelizeOptions options;
    options.voxel = 0.05;
    options.half_width = 6;
    const field::Field field = field::make("sphere", {{"radius", 1.0}});
    return std::make_shared<const volume::Density>(volume::fog(volume::voxelize(field, options)));
  }();
  return density;
}

MediumPtr cloud(double extinction, double albedo, double g = 0, const Vec3d& emission = Vec3d(0)) {
  return make_medium("cloud", {{"extinction", extinction},
                               {"albedo", Vec3d(albedo)},
                               {"g", g},
                               {"emission", emission}})
      ->with_density(ball());
}

/// Integral of the density along a ray between two distances, by the midpoint rule.
double integral(const Ray& ray, double begin, double end) {
  constexpr int kSteps = 20000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = begin + (end - begin) * (i + 0.5) / kSteps;
    sum += static_cast<double>(ball()->at(ball()->to_index(ray.at(static_cast<float>(t)))));
  }
  return sum * (end - begin) / kSteps;
}

TEST(Cloud, DensityIsThatOfTheGrid) {
  EXPECT_FLOAT_EQ(ball()->at(ball()->to_index(Vec3f(0.0f))), 1);
  EXPECT_NEAR(ball()->at(ball()->to_index({0, 0.85f, 0})), 0.5, 0.05);
  EXPECT_EQ(ball()->at(ball()->to_index({0, 1.2f, 0})), 0);
  EXPECT_EQ(ball()->at({-1, 2, 3}), 0);
}

TEST(Cloud, FreePathsAreLogarithms) {
  EXPECT_EQ(free_path(0), 0);
  for (int i = 1; i < 1 << 24; i += 17) {
    const float u = static_cast<float>(i) * 0x1p-24f;
    const double path = -std::log1p(-static_cast<double>(u));
    ASSERT_NEAR(static_cast<double>(free_path(u)), path, 2e-7 * path) << u;
  }
}

TEST(Cloud, TransmittanceMatchesTheIntegral) {
  const Ray rays[] = {{{0.1f, 0.2f, -3}, {0, 0, 1}},
                      {{-2, -1.5f, 0.3f}, normalized(Vec3f(1, 0.8f, 0))},
                      {{0, 0, 0}, normalized(Vec3f(1, 2, 3))}};
  for (const double extinction : {0.5, 6.0})
    for (const Ray& ray : rays) {
      const MediumPtr medium = cloud(extinction, 1);
      const Segment segment = medium->clip(ray, kFar);
      ASSERT_FALSE(segment.empty());
      const double clear = std::exp(-extinction * integral(ray, 0, 8));
      constexpr int kTrials = 40000;
      double sum = 0, squares = 0;
      int through = 0;
      RandomStream random(RandomKey(4));
      for (int i = 0; i < kTrials; ++i) {
        const auto u = [&] { return static_cast<float>(random.uniform()); };
        const float a = u(), b = u();
        TrackingRng numbers(Vec2f(a, b));
        const auto t = static_cast<double>(medium->transmittance(ray, segment, numbers));
        sum += t, squares += t * t;
        through += !medium->sample_distance(ray, segment, u(), numbers).scattered;
      }
      const double mean = sum / kTrials;
      const double error = std::sqrt((squares / kTrials - mean * mean) / kTrials);
      EXPECT_NEAR(mean, clear, 4 * error + 1e-4);
      EXPECT_NEAR(static_cast<double>(through) / kTrials, clear,
                  4 * std::sqrt(clear * (1 - clear) / kTrials) + 1e-4);
    }
}

TEST(Cloud, SetsTheTransmittanceOfScatterPoints) {
  const Ray ray{{0.1f, 0.2f, -3}, {0, 0, 1}};
  for (const double extinction : {0.5, 6.0}) {
    const MediumPtr medium = cloud(extinction, 1);
    const Segment segment = medium->clip(ray, kFar);
    // Not in order; one is before the density and one behind it.
    const float places[] = {3.1f, segment.begin, 2.2f, segment.end};
    std::array<double, 4> sum{}, squares{};
    int met = 0;
    constexpr int kTrials = 40000;
    RandomStream random(RandomKey(5));
    for (int i = 0; i < kTrials; ++i) {
      const auto u = [&] { return static_cast<float>(random.uniform()); };
      const float a = u(), b = u();
      TrackingRng numbers(Vec2f(a, b));
      std::array<ScatterPoint, 4> scatter_points;
      for (size_t m = 0; m < scatter_points.size(); ++m) scatter_points[m].distance = places[m];
      const DistanceSample sample =
          medium->sample_distance(ray, segment, u(), scatter_points, numbers);
      met += sample.scattered && sample.distance < places[0];
      for (size_t m = 0; m < scatter_points.size(); ++m) {
        const auto clear = static_cast<double>(scatter_points[m].transmittance);
        sum[m] += clear, squares[m] += clear * clear;
      }
    }
    for (size_t m = 0; m < sum.size(); ++m) {
      const double clear = std::exp(-extinction * integral(ray, 0, static_cast<double>(places[m])));
      const double mean = sum[m] / kTrials;
      const double error = std::sqrt(std::max(squares[m] / kTrials - mean * mean, 0.0) / kTrials);
      EXPECT_NEAR(mean, clear, 4 * error + 1e-4) << extinction << ", mark " << m;
    }
    const double before = 1 - std::exp(-extinction * integral(ray, 0, 3.1));
    EXPECT_NEAR(static_cast<double>(met) / kTrials, before,
                4 * std::sqrt(before * (1 - before) / kTrials) + 1e-4);
  }
}

TEST(Cloud, WhiteCloudVanishesInAWhiteSky) {
  Scene scene;
  scene.camera = view({0, 0, 5}, {0, 0, 0}, 0.3);
  scene.lights = {make_light("sky")};
  scene.medium = cloud(3, 1, 0.5);
  Options o = options(24, 24, 160, 300);
  o.openings = false;
  const Mean mean = mean_of(render(scene, o), "G");
  EXPECT_NEAR(mean.value, 1, 4 * mean.error);
  EXPECT_LT(mean.error, 3e-3);
}

// A black emissive cloud: its light along a ray is its emission times its absorption.
TEST(Cloud, EmissionIsProportionalToAbsorption) {
  Scene scene;
  scene.camera = view({0, 0, 5}, {0, 0, 0}, 1e-3);
  scene.medium = cloud(0.7, 0, 0, {2, 1, 0.5});
  const Mean mean = mean_of(render(scene, options(32, 32, 64, 0)), "R");
  const double clear = std::exp(-0.7 * integral({{0, 0, 5}, {0, 0, -1}}, 0, 10));
  EXPECT_NEAR(mean.value, 2 * (1 - clear), 4 * mean.error);
}

// Single scattering from a light behind the cloud's centre, against quadrature with the same light.
TEST(Cloud, SingleScatteringMatchesQuadrature) {
  Scene scene;
  scene.camera = view({0, 0, 3}, {0, 0, 0}, 1e-4);
  const double radius = 0.01, radiance = 1e4, extinction = 0.8;
  const Vec3f light(0, 1.6f, 0);
  scene.lights = {make_light(
      "sphere", {{"center", Vec3d(light)}, {"radius", radius}, {"radiance", Vec3d(radiance)}})};
  scene.medium = cloud(extinction, 1);
  const Mean mean = mean_of(render(scene, options(32, 32, 256, 0)), "G");
  const Ray ray{{0, 0, 3}, {0, 0, -1}};
  constexpr int kSteps = 400;
  double expected = 0;
  for (int i = 0; i < kSteps; ++i) {
    const double t = 1.9 + 2.2 * (i + 0.5) / kSteps;
    const Vec3f point = ray.at(static_cast<float>(t));
    const Vec3f to = light - point;
    const auto d = static_cast<double>(length(to));
    const double solid = 2 * kPi * (1 - std::sqrt(1 - radius * radius / (d * d)));
    const double depth = integral(ray, 1.9, t) * 1.0 + integral({point, normalized(to)}, 0, d);
    expected += 2.2 / kSteps * extinction *
                static_cast<double>(ball()->at(ball()->to_index(point))) / (4 * kPi) * radiance *
                solid * std::exp(-extinction * depth);
  }
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + 2e-3 * expected);
  EXPECT_LT(mean.error, 6e-3 * expected);
}

TEST(Cloud, HasTheSameBytesForAnyNumberOfThreads) {
  const auto picture = [](int threads) {
    Scene scene;
    scene.camera = view({0, 0, 5}, {0, 0, 0}, 0.5);
    scene.lights = {make_light("sphere", {{"center", Vec3d(0, 2, 0)}, {"radiance", Vec3d(10)}})};
    scene.medium = cloud(4, 0.9, 0.6);
    Options o = options(16, 12, 16, 6);
    o.threads = threads;
    return render(scene, o);
  };
  const image::Image one = picture(1);
  EXPECT_EQ(one, picture(2));
  EXPECT_EQ(one, picture(7));
}

}  // namespace
}  // namespace vug::render
