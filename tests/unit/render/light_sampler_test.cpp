// SPDX-License-Identifier: Apache-2.0
// The choice of lights changes the noise, but not the expected picture.
#include "runs.h"

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

/// A glossy floor under lamps of which each view direction reflects one at most.
Scene glossy_floor_under_lamps() {
  Scene scene;
  scene.objects.push_back(object(floor_mesh(3), 0.3));
  scene.objects[0].material =
      make_material("surface", {{"color", Vec3d(0.3)}, {"coat", 1.0}, {"coat_roughness", 0.25}});
  for (int i = 0; i < 6; ++i)
    scene.lights.push_back(
        make_light("sphere", {{"center", Vec3d(0.6 * i - 1.5, 0.5, -1.2 + 0.3 * (i % 2))},
                              {"radius", 0.05},
                              {"radiance", Vec3d(20.0 + 5 * i)},
                              {"visible", false}}));
  scene.camera = view({0, 0.8, 2}, {0, 0, -0.5}, 0.9);
  return scene;
}

/// On glossy surfaces the lights that get a shadow ray are those that the surface reflects.
TEST(LightSampler, PrefersTheLampsThatAGlossyFloorReflects) {
  const Scene scene = glossy_floor_under_lamps();
  const auto taken = [&](const char* sampler, int light_samples, int spp, uint64_t seed) {
    Options o = options(24, 16, spp, 0);
    o.aovs = plan_aovs({"beauty", "variance"}, {});
    o.seed = seed;
    o.integrator = make_integrator("path", {{"max_bounces", 0},
                                            {"guide", Value::Name{"off"}},
                                            {"light_samples", light_samples},
                                            {"light_sampler", Value::Name{sampler}}});
    return render(scene, o);
  };
  constexpr int kRuns = 8;
  Runs runs[2];
  for (int run = 0; run < kRuns; ++run)
    for (const int all : {0, 1}) {
      const auto seed = static_cast<uint64_t>(run + 1);
      // All six lamps have a shadow ray, or the one that was chosen.
      runs[all].add(taken(all ? "uniform" : "tree", all ? 6 : 1, 64, seed));
    }
  const double error = error_of_difference(runs[0], runs[1]);
  EXPECT_LT(std::fabs(runs[0].mean() - runs[1].mean()), 3 * error);
  EXPECT_LT(error, 0.01 * runs[1].mean());
  RecordProperty("variance_ratio", std::to_string(runs[0].variance() / runs[1].variance()));
  EXPECT_LT(runs[0].variance(), 4 * runs[1].variance())
      << "a sixth of the shadow rays; 9 by the lamps alone";
}

}  // namespace
}  // namespace vug::render
