// SPDX-License-Identifier: Apache-2.0
// Significance tests on real renders, as in a user's regression test.
#include "scenes.h"

#include <vug/image/significance.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

/// A ball in a closed rock room, lit by one light.
Scene room_with_ball(double ball_albedo = 0.7) {
  Scene scene;
  scene.camera = view({0, 0, 1.9}, {0, -0.3, 0}, 1.2);
  scene.objects = {
      object(mesh::box_mesh({Vec3d(-2), Vec3d(2)}), 0.5),
      object(with_radial_normals(mesh::sphere_mesh({0, -0.8, 0}, 0.5, 3), 1), ball_albedo)};
  scene.lights = {make_light("rect", {{"center", Vec3d(1.9, 0.6, 0)},
                                      {"normal", Vec3d(-1, -0.3, 0)},
                                      {"width", 0.4},
                                      {"height", 0.4},
                                      {"radiance", Vec3d(9, 6, 3)}})};
  return scene;
}

image::NoisyPicture shot(const Scene& scene, int spp, uint64_t seed) {
  Options o = options(40, 24, spp, 4);
  o.seed = seed;
  const image::Image picture = render(scene, o);
  image::NoisyPicture out;
  out.mean = picture.select({"R", "G", "B"});
  out.variance = picture.select({"variance.R", "variance.G", "variance.B"});
  out.variance->channels = out.mean.channels;
  out.samples.assign(picture.pixel_count(), static_cast<float>(spp));
  return out;
}

TEST(SignificanceOfRenders, AHundredSeedsRaiseNoMoreAlarmsThanChosen) {
  const Scene scene = room_with_ball();
  const image::NoisyPicture reference = shot(scene, 32, 1000);
  int alarms = 0;
  for (uint64_t seed = 0; seed < 100; ++seed)
    if (test_significance(reference, shot(scene, 32, seed)).different) ++alarms;
  EXPECT_LE(alarms, 1) << "at a rate of 0.01";
}

TEST(SignificanceOfRenders, FewSamplesAgainstManyRaiseNoAlarm) {
  const Scene scene = room_with_ball();
  const image::NoisyPicture reference = shot(scene, 512, 1000);
  int alarms = 0;
  for (uint64_t seed = 0; seed < 30; ++seed)
    if (test_significance(reference, shot(scene, 8, seed)).different) ++alarms;
  EXPECT_LE(alarms, 2);
}

TEST(SignificanceOfRenders, OnePercentLessLightIsDetected) {
  const Scene scene = room_with_ball();
  const image::NoisyPicture reference = shot(scene, 256, 1);
  for (uint64_t seed = 2; seed < 5; ++seed) {
    image::NoisyPicture darker = shot(scene, 256, seed);
    for (float& v : darker.mean.pixels) v *= 0.99f;
    for (float& v : darker.variance->pixels) v *= 0.99f * 0.99f;
    const image::Significance found = test_significance(reference, darker);
    EXPECT_TRUE(found.different) << seed;
    EXPECT_NEAR(found.bias, -0.01, 0.003);
  }
}

TEST(SignificanceOfRenders, AnotherMaterialIsDetected) {
  const image::NoisyPicture reference = shot(room_with_ball(0.7), 256, 1);
  for (uint64_t seed = 2; seed < 5; ++seed)
    EXPECT_TRUE(test_significance(reference, shot(room_with_ball(0.6), 256, seed)).different)
        << seed;
}

}  // namespace
}  // namespace vug::render
