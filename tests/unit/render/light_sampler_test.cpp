// SPDX-License-Identifier: Apache-2.0
// The choice of lights changes the noise, but not the expected picture.
#include "scenes.h"

#include <gtest/gtest.h>

namespace vug::render {
namespace {

/// A floor with an emissive ball, a sun, portals to the sky (one of them upright), and a row of
/// lights, two of which light only other objects; in haze.
Scene scene_of_many_lights() {
  Scene scene;
  scene.objects.push_back(object(floor_mesh(3), 0.6));
  Object ball = object(mesh::sphere_mesh({0.8, 0.5, -1}, 0.3, 2), 0.5);
  ball.name = "ball", ball.emission = Rgb(0.5f, 0.8f, 1);
  scene.objects.push_back(ball);
  for (int i = 0; i < 20; ++i)
    scene.lights.push_back(
        make_light("sphere", {{"center", Vec3d(0.2 * i - 2, 0.7 + 0.05 * (i % 4), -0.4)},
                              {"radius", 0.04},
                              {"only", i % 10 == 3 ? "ball" : "object"},
                              {"radiance", Vec3d(2.0 + i)}}));
  scene.lights.push_back(make_light("sun", {{"irradiance", Vec3d(0.2)}}));
  scene.lights.push_back(make_light("sky", {{"radiance", Vec3d(2)}}));
  scene.lights.push_back(
      make_light("portal", {{"center", Vec3d(0, 3, 0)}, {"normal", Vec3d(0, -1, 0)}}));
  scene.lights.push_back(make_light(
      "portal", {{"center", Vec3d(0.5, 0.5, 0)}, {"normal", Vec3d(1, 0, 0)}, {"width", 2.0}}));
  scene.medium = make_medium("haze", {{"extinction", 0.1}});
  scene.camera = view({1, 2.5, 1.5}, {1, 0, -0.3}, 0.9);
  return scene;
}

TEST(LightSampler, HasTheSameMean) {
  constexpr int kRuns = 12;
  double mean[3] = {}, square[3] = {};
  for (int run = 0; run < kRuns; ++run)
    for (const int way : {0, 1, 2}) {
      Options o = options(16, 12, 128, 4);
      o.integrator =
          make_integrator("path", {{"max_bounces", 4},
                                   {"guide", Value::Name{"off"}},
                                   {"light_samples", way == 2 ? 4 : 1},
                                   {"light_sampler", Value::Name{way == 0 ? "tree" : "uniform"}}});
      o.seed = static_cast<uint64_t>(run + 1);
      const double m = mean_of(render(scene_of_many_lights(), o), "R").value;
      mean[way] += m / kRuns;
      square[way] += m * m / kRuns;
    }
  double variance[3] = {};
  for (const int way : {0, 1, 2})
    variance[way] = (square[way] - mean[way] * mean[way]) / (kRuns - 1);
  EXPECT_GT(mean[0], 0.01);
  for (const int way : {1, 2}) {
    const double error = std::sqrt(variance[0] + variance[way]);
    EXPECT_LT(std::fabs(mean[0] - mean[way]), 4 * error) << way;
    EXPECT_LT(error, 0.01 * mean[0]) << way;
    EXPECT_NE(mean[way], mean[0]) << way << " chooses as the tree does";
  }
}

}  // namespace
}  // namespace vug::render
