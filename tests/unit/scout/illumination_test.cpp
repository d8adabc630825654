// SPDX-License-Identifier: Apache-2.0
// The estimate of light against closed forms.
#include "rooms.h"
#include "synthetic.h"

#include <vug/base/parallel.h>
#include <vug/render/kinds.h>
#include <vug/scout/illumination.h>
#include <vug/scout/pose.h>
#include <vug/scout/trace_view.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::scout {
namespace {

const char* const kGround =
    "volume ground = level_set(box(size: (40, 2, 40)).translate((0, -1, 0)), voxel: 1m)\n";

/// A view of the ground from a height of 10 m, straight down.
View view_down(const Location& location) {
  return trace_view(*location.world, *camera_of({Vec3d(0, 10, 0), 0, -89.9 * kDegree, 0.1}));
}

double mean(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

TEST(Illumination, ASphereLightsTheGroundBelowByItsSolidAngle) {
  const Room room(kGround);
  const View view = view_down(room.location);
  const double r = 0.5, d = 6, radiance = 3;
  const auto light = render::make_light(
      "sphere", {{"center", Vec3d(0, d, 0)}, {"radius", r}, {"radiance", Vec3d(radiance)}});
  const auto values = illuminate(*room.location.world, {light}, view, RandomKey(1), {.rays = 0});
  // E = pi L (r / d)^2 below the sphere, and the grey ground reflects E albedo / pi.
  EXPECT_NEAR(mean(values), 0.5 * radiance * (r / d) * (r / d),
              0.01 * 0.5 * radiance * r * r / d / d);
}

TEST(Illumination, AUniformSkyLightsOpenGroundByItsRadiance) {
  const Room room(kGround);
  const auto sky = render::make_light("sky", {{"radiance", Vec3d(2.0)}});
  for (const float value :
       illuminate(*room.location.world, {sky}, view_down(room.location), RandomKey(1)))
    EXPECT_NEAR(value, 0.5 * 2, 1e-5);
}

TEST(Illumination, LightAddsUpAndWallsCastShadows) {
  const Room room(hall("camera main { eye (0, 2, 0)  target (1, 2, 0) }\n"));
  const View view = trace_view(*room.location.world, *room.loaded.shot.cameras[0].camera);
  const auto lamp = [](const Vec3d& at) {
    return render::make_light("sphere",
                              {{"center", at}, {"radius", 0.2}, {"radiance", Vec3d(9.0)}});
  };
  const auto lit = [&](const std::vector<render::LightPtr>& lights) {
    return mean(illuminate(*room.location.world, lights, view, RandomKey(1), {.rays = 0}));
  };
  const double a = lit({lamp({5, 3, 1})}), b = lit({lamp({8, 2, -1})});
  EXPECT_GT(a, 0);
  EXPECT_NEAR(lit({lamp({5, 3, 1}), lamp({8, 2, -1})}), a + b, 0.1 * (a + b));
  EXPECT_LT(lit({lamp({5, 3, 9})}), 1e-3 * a) << "a lamp in the rock";
}

TEST(Illumination, TheSameForAnyNumberOfThreads) {
  const Room room(hall("light lamp = sphere(center: (3, 3, 1), radius: 10cm, lumen: 900)\n"));
  const View view = trace_view(*room.location.world, *camera_of({Vec3d(-6, 1.6, 0), 0, 0, 1}));
  const auto values = [&](int threads) {
    return with_threads(threads, [&] {
      return illuminate(*room.location.world, room.location.scene.lights, view, RandomKey(3));
    });
  };
  const auto one = values(1);
  EXPECT_EQ(values(2), one);
  EXPECT_EQ(values(7), one);
}

TEST(Illumination, DarkPicturesAreWorthless) {
  const View view = view_of([](double, double) { return surface(5); });
  const size_t n = view.pixels.size();
  const auto terms = [&](const std::vector<float>& luminance) {
    return light_terms(luminance, view);
  };
  const double flat = terms(std::vector<float>(n, 5)).total();
  EXPECT_GT(flat, 0.5);
  EXPECT_LT(flat, 1);
  EXPECT_EQ(terms(std::vector<float>(n, 0)).total(), 0);
  std::vector<float> half(n, 0);
  std::fill_n(half.begin(), n / 2, 1.0f);
  EXPECT_NEAR(terms(half).black, 0.5, 1e-3);
  EXPECT_EQ(terms(half).total(), flat) << "half of a good picture may be black";
  std::fill_n(half.begin() + static_cast<std::ptrdiff_t>(n / 10), n / 2, 0.0f);
  EXPECT_LT(terms(half).total(), 0.01);
}

TEST(Illumination, ADarkPillarInFrontOfALitWallIsASilhouette) {
  // A quarter of the width, full height: two edges, each as long as the picture is high.
  const auto is_pillar = [](double u) { return u > 0.375 && u < 0.625; };
  const View view = view_of([&](double u, double) { return surface(is_pillar(u) ? 4 : 12); });
  const auto lit = [&](float pillar, float wall) {
    std::vector<float> luminance;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x)
        luminance.push_back(is_pillar((x + 0.5) / view.width) ? pillar : wall);
    return light_terms(luminance, view);
  };
  EXPECT_DOUBLE_EQ(lit(0.1f, 1).silhouettes, 2.0 * kViewHeight / kViewWidth);
  EXPECT_EQ(lit(0.1f, 1).total(), 1);
  EXPECT_EQ(lit(0.3f, 1).silhouettes, 0) << "hardly darker";
  EXPECT_EQ(lit(1, 0.1f).silhouettes, 0) << "a lit pillar in front of darkness";
  EXPECT_EQ(lit(1e-6f, 1e-5f).silhouettes, 2.0 * kViewHeight / kViewWidth)
      << "the exposure decides what is visible";
}

}  // namespace
}  // namespace vug::scout
