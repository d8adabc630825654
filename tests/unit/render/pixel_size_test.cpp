// SPDX-License-Identifier: Apache-2.0
#include <vug/render/cameras/pixel_size.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::render {
namespace {

/// At the origin, looking along -z, 90 degrees wide.
CameraPtr camera_at(const Vec3d& eye) {
  return make_camera(
      "perspective",
      {{"eye", eye}, {"target", eye - Vec3d(0, 0, 1)}, {"fov", Number{kPi / 2, Dimension::angle}}});
}

PixelSize pixels_of(std::vector<CameraPtr> cameras, double off_screen = 4) {
  return {std::move(cameras), {200, 100}, off_screen};
}

TEST(PixelSize, IsProportionalToTheDistance) {
  const PixelSize pixel = pixels_of({camera_at(Vec3d(0))});
  for (const double distance : {0.1, 1.0, 30.0})
    EXPECT_NEAR(pixel.at({0, 0, -distance}), 2 * distance / 200, 1e-4 * distance);
}

TEST(PixelSize, DoesNotDependOnTheDistanceForParallelRays) {
  const CameraPtr camera =
      make_camera("orthographic", {{"eye", Vec3d(0)}, {"target", Vec3d(0, 0, -1)}, {"width", 3.0}});
  for (const double distance : {0.1, 1.0, 30.0})
    EXPECT_NEAR(pixels_of({camera}).at({0.2, 0.1, -distance}), 3.0 / 200, 1e-5);
}

TEST(PixelSize, GrowsOutsideThePicture) {
  const PixelSize pixel = pixels_of({camera_at(Vec3d(0))});
  const auto turned = [](double degrees) {
    const double angle = degrees * kPi / 180;
    return Vec3d(std::sin(angle), 0, -std::cos(angle));
  };
  // Continuous at the edge, 45 degrees from the axis, and growing from there.
  EXPECT_NEAR(pixel.at(turned(44.99)) / pixel.at(turned(45.01)), 1, 0.02);
  double last = pixel.at(turned(45));
  for (double degrees = 50; degrees <= 85; degrees += 5) {
    const double here = pixel.at(turned(degrees));
    EXPECT_GT(here, last);
    last = here;
  }
  EXPECT_NEAR(pixel.at({0, 0, 1}), 4 * pixel.at({0, 0, -1}), 1e-6);
  EXPECT_NEAR(pixels_of({camera_at(Vec3d(0))}, 1).at({0, 0, 1}), 0.01, 1e-5);
}

TEST(PixelSize, IsThatOfTheNearestCamera) {
  const CameraPtr near = camera_at(Vec3d(0)), far = camera_at({0, 0, 9});
  const Vec3d point(0.1, 0.1, -1);
  EXPECT_EQ(pixels_of({near, far}).at(point), pixels_of({near}).at(point));
  EXPECT_EQ(pixels_of({far, near}).at(point), pixels_of({near}).at(point));
  EXPECT_LT(pixels_of({near}).at(point), pixels_of({far}).at(point));
}

}  // namespace
}  // namespace vug::render
