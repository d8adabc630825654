// A guide makes paths find light sooner; it does not change what they find.
#include "scenes.h"

#include <gtest/gtest.h>

namespace vug::render {
namespace {

/// A hollow ball with a sill before its lamp: most of it is lit over other walls only.
Scene hidden_lamp() {
  Scene scene;
  scene.objects.push_back(object(mesh::sphere_mesh(Vec3d(0), 1, 4), 0.6));
  mesh::Mesh sill = floor_mesh(0.5f);
  for (Vec3f& p : sill.positions) p.y += 0.45f;
  scene.objects.push_back(object(std::move(sill), 0.6));
  scene.lights.push_back(make_light(
      "sphere", {{"center", Vec3d(0, 0.6, 0)}, {"radius", 0.05}, {"radiance", Vec3d(60, 50, 40)}}));
  scene.camera = view({0, -0.2, 0.8}, {0, -0.3, 0}, 1.2);
  return scene;
}

image::Image picture(const char* guide, uint64_t seed, int spp, int threads = 0) {
  Options o = options(16, 12, spp, 6);
  o.integrator = make_integrator("path", {{"max_bounces", 6}, {"guide", Value::Name{guide}}});
  o.seed = seed;
  o.threads = threads;
  return render(hidden_lamp(), o);
}

TEST(GuidedPath, HasTheSameMean) {
  constexpr int kRuns = 12;
  double mean[2] = {0, 0}, square[2] = {0, 0};
  for (int run = 0; run < kRuns; ++run)
    for (int led = 0; led < 2; ++led) {
      const double m =
          mean_of(picture(led ? "on" : "off", static_cast<uint64_t>(run + 1), 256), "R").value;
      mean[led] += m / kRuns;
      square[led] += m * m / kRuns;
    }
  double variance = 0;
  for (int led = 0; led < 2; ++led) variance += (square[led] - mean[led] * mean[led]) / (kRuns - 1);
  EXPECT_GT(mean[0], 0);
  EXPECT_LT(std::fabs(mean[1] - mean[0]), 4 * std::sqrt(variance));
  EXPECT_LT(std::sqrt(variance), 0.01 * mean[0]);
}

TEST(GuidedPath, HasTheSameBytesForAnyNumberOfThreads) {
  const image::Image one = picture("on", 5, 16, 1);
  EXPECT_EQ(one, picture("on", 5, 16, 2));
  EXPECT_EQ(one, picture("on", 5, 16, 7));
}

}  // namespace
}  // namespace vug::render
