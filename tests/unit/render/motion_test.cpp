// SPDX-License-Identifier: Apache-2.0
// Motion blur against closed forms.
#include <vug/base/error.h>
#include <vug/render/cameras/moving_camera.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

/// Looks down at the floor; up in the picture is -z.
CameraPtr from_above(double x) {
  return make_camera("orthographic", {{"eye", Vec3d(x, 3, 0)},
                                      {"target", Vec3d(x, 0, 0)},
                                      {"up", Vec3d(0, 0, -1)},
                                      {"width", 4.0}});
}

Scene square_under(CameraPtr camera) {
  Scene scene;
  scene.objects = {object(floor_mesh(0.5f), 0.5)};
  scene.lights = {make_light("sky")};
  scene.camera = std::move(camera);
  return scene;
}

float alpha_at(const image::Image& picture, int x, int y) {
  return picture.at(x, y, static_cast<size_t>(picture.find_channel("A")));
}

// While the camera moves by `way`, an edge sweeps over that part of the picture: the coverage of a
// pixel grows in proportion to its distance from the end of the ramp.
TEST(Motion, AMovingEdgeIsARamp) {
  constexpr double kWay = 0.8;
  Options o = options(80, 20, 1024, 0);
  o.aovs = plan_aovs({"beauty", "A"}, {});
  const image::Image picture =
      render(square_under(moving_camera({from_above(-kWay / 2), from_above(kWay / 2)})), o);
  constexpr double kPixel = 4.0 / 80;
  for (int x = 0; x < 80; ++x) {
    // A point at u in the picture's middle position is at u + way (t - 1/2) at time t.
    const auto covered = [&](double u) {
      const double from = std::max(u - kWay / 2, -0.5), to = std::min(u + kWay / 2, 0.5);
      return std::max(0.0, to - from) / kWay;
    };
    double expected = 0;
    for (int i = 0; i < 64; ++i) expected += covered(-2 + kPixel * (x + (i + 0.5) / 64)) / 64;
    // Samples are stratified over time and film: the error is far below that of independent
    // samples.
    const double error = 4 * std::sqrt(expected * (1 - expected) / 1024) + 1e-6;
    EXPECT_NEAR(alpha_at(picture, x, 10), expected, error) << "pixel " << x;
  }
}

// The same ramp and the same light if the square moves instead of the camera.
TEST(Motion, AMovingInstanceIsARamp) {
  constexpr double kWay = 0.8;
  const auto moved = [](double x) { return Transform::translation({x, 0, 0}); };
  Scene scene = square_under(from_above(0));
  scene.objects[0].instance = std::make_shared<InstanceTransform>(
      std::vector<Transform>{moved(-kWay / 2), moved(0), moved(kWay / 2)});
  Options o = options(80, 20, 1024, 0);
  const image::Image picture = render(scene, o);
  const image::Image other =
      render(square_under(moving_camera({from_above(kWay / 2), from_above(-kWay / 2)})), o);
  const auto red = static_cast<size_t>(picture.find_channel("R"));
  for (int x = 0; x < 80; ++x) {
    EXPECT_NEAR(alpha_at(picture, x, 10), alpha_at(other, x, 10), 1e-3) << "pixel " << x;
    EXPECT_NEAR(picture.at(x, 10, red), other.at(x, 10, red), 0.01f * other.at(x, 10, red) + 1e-3f);
  }
  scene.objects[0].instance = std::make_shared<InstanceTransform>(moved(0));
  EXPECT_EQ(render(scene, options(80, 20, 4, 1)).select({"A"}),
            render(square_under(from_above(0)), options(80, 20, 4, 1)).select({"A"}));
}

// Shadows move with their casters: the mean light below a sheet that is present for a fraction of
// the exposure is that of the fraction without it.
TEST(Motion, ShadowsUseTheTimeOfTheirPath) {
  Scene scene;
  scene.camera = from_above(0);
  mesh::Mesh sheet = floor_mesh(100);
  for (Vec3f& p : sheet.positions) p.y = 4;  // above the camera, so that only its shadow is visible
  scene.objects = {object(floor_mesh(1), 0.5), object(sheet, 0)};
  scene.lights = {make_light("sky")};
  // 300 m in eight steps: out of reach after the first third of the time.
  std::vector<Transform> places;
  for (int i = 0; i <= 8; ++i) places.push_back(Transform::translation({300.0 * i / 8, 0, 0}));
  scene.objects[1].instance = std::make_shared<InstanceTransform>(places);
  const auto light = [&] {
    const image::Image picture = render(scene, options(16, 8, 1024, 0));
    return static_cast<double>(picture.at(8, 4, static_cast<size_t>(picture.find_channel("G"))));
  };
  const double seen = light();
  scene.objects.pop_back();
  EXPECT_NEAR(seen / light(), 2.0 / 3, 0.03);
}

TEST(Motion, WithoutMovingObjectsThePictureIsStatic) {
  Options o = options(40, 10, 16, 2);
  const image::Image still = render(square_under(from_above(0)), o);
  EXPECT_EQ(render(square_under(moving_camera({from_above(0)})), o), still);
  const CameraPtr pretends = moving_camera({from_above(0), from_above(0), from_above(0)});
  EXPECT_TRUE(pretends->moves());
  const image::Image moved = render(square_under(pretends), o);
  for (size_t i = 0; i < still.pixels.size(); ++i)  // the same numbers are used
    ASSERT_NEAR(moved.pixels[i], still.pixels[i], 1e-5f * std::fabs(still.pixels[i]) + 1e-6f) << i;
}

TEST(Motion, CameraPassesItsMoments) {
  const auto at = [](double x) {
    return make_camera("perspective", {{"eye", Vec3d(x, 0, 5)}, {"target", Vec3d(x, 0, 0)}});
  };
  const CameraPtr camera = moving_camera({at(0), at(1), at(5)});
  for (const auto& [time, x] :
       {std::pair(0.0f, 0.0f), std::pair(0.25f, 0.5f), std::pair(0.5f, 1.0f),
        std::pair(0.75f, 3.0f), std::pair(1.0f, 5.0f)}) {
    const Ray ray = camera->ray_at(time, {0.2f, 0.7f}, 1.5f, {});
    EXPECT_NEAR(ray.origin.x, x, 1e-6);
    EXPECT_NEAR(length(ray.direction - at(0)->ray({0.2f, 0.7f}, 1.5f, {}).direction), 0, 1e-6);
  }
  EXPECT_EQ(camera->position(), at(1)->position());
  EXPECT_NEAR(camera->depth_at(1, {0, 0, -3}), 8, 1e-6);
  EXPECT_THROW(moving_camera({}), Error);
}

// A camera that moves to the right moves the picture to the left, nearer objects faster.
TEST(Motion, AovIsInPixelsToTheNextFrame) {
  const auto at = [](double x) {
    return make_camera("perspective", {{"eye", Vec3d(x, 2, 0)},
                                       {"target", Vec3d(x, 0, 0)},
                                       {"up", Vec3d(0, 0, -1)},
                                       {"fov", radians(kPi / 2)}});
  };
  Scene scene = square_under(at(0));
  scene.objects = {object(floor_mesh(9), 0.5)};
  Options o = options(40, 20, 4, 0);
  o.aovs = plan_aovs({"beauty", "parts", "motion"}, {});
  const auto mean = [&](const std::string& channel) { return mean_of(render(scene, o), channel); };
  EXPECT_EQ(mean("motion.X").value, 0);
  const image::Image without = render(scene, o).select({"R", "G", "B"});
  auto step = std::make_shared<MotionStep>();
  step->now = at(0), step->next = at(0.3);
  o.motion_step = step;
  // The picture's 40 pixels span 4 m of the floor.
  EXPECT_NEAR(mean("motion.X").value, -3, 1e-4);
  EXPECT_NEAR(mean("motion.Y").value, 0, 1e-4);
  EXPECT_EQ(render(scene, o).select({"R", "G", "B"}), without);
  step->next = make_camera("perspective", {{"eye", Vec3d(0, 2, 0.2)},
                                           {"target", Vec3d(0, 0, 0.2)},
                                           {"up", Vec3d(0, 0, -1)},
                                           {"fov", radians(kPi / 2)}});
  EXPECT_NEAR(mean("motion.Y").value, 2, 1e-4) << "the floor behind the camera's motion moves up";
  step->next = step->now;
  scene.objects[0].instance =
      std::make_shared<InstanceTransform>(Transform::translation({1, 0, 0}));
  step->transforms[0] = {Affine(Transform::translation({1, 0, 0})),
                         Affine(Transform::translation({1.2, 0, 0}))};
  EXPECT_NEAR(mean("motion.X").value, 2, 1e-4);
  scene.objects[0].instance = nullptr, step->transforms.clear();
  const auto round = [](double turn) {
    return make_camera("panoramic", {{"eye", Vec3d(0, 2, 0)},
                                     {"target", Vec3d(std::sin(turn), 2, -std::cos(turn))}});
  };
  step->now = round(0), step->next = round(0.1 * kPi);
  scene.camera = step->now;
  // 1/20 of a turn to the right on 40 pixels, also across the seam; half of the picture is sky.
  const image::Image all = render(scene, o);
  const auto motion = static_cast<size_t>(all.find_channel("motion.X"));
  for (int x = 0; x < 40; ++x) EXPECT_NEAR(all.at(x, 18, motion), -2, 1e-3) << x;
}

// A picture of slices equals the whole picture also with motion.
TEST(Motion, DoesNotDependOnThreads) {
  Options o = options(40, 10, 16, 2);
  const Scene scene = square_under(moving_camera({from_above(-0.2), from_above(0.3)}));
  o.threads = 1;
  const image::Image one = render(scene, o);
  for (const int threads : {2, 5, 8}) {
    o.threads = threads;
    EXPECT_EQ(render(scene, o), one) << threads;
  }
}

}  // namespace
}  // namespace vug::render
