// White furnaces: whatever the paths do, the sum of reflections is known.
#include "scenes.h"

#include <gtest/gtest.h>

namespace vug::render {
namespace {

double largest_error(const image::Image& picture, double expected) {
  double worst = 0;
  for (const char* name : {"R", "G", "B"}) {
    const auto c = static_cast<size_t>(picture.find_channel(name));
    for (size_t i = c; i < picture.pixels.size(); i += picture.channels.size())
      worst = std::max(worst, std::fabs(static_cast<double>(picture.pixels[i]) - expected));
  }
  return worst;
}

// A convex body that reflects everything looks like the sky it stands in.
TEST(Furnace, WhiteSphereVanishesInAWhiteSky) {
  Scene scene;
  scene.camera = view({0, 0, 4}, {0, 0, 0}, 0.9);
  scene.objects = {object(mesh::sphere_mesh({0, 0, 0}, 1, 4), 1)};
  scene.lights = {make_light("sky")};
  EXPECT_LT(largest_error(render(scene, options(48, 32, 16, 8)), 1), 1e-5);
}

// With smooth normals some directions fall below the real surface and are lost: little.
TEST(Furnace, SmoothNormalsLoseLittle) {
  Scene scene;
  scene.camera = view({0, 0, 4}, {0, 0, 0}, 0.4);
  scene.objects = {object(with_radial_normals(mesh::sphere_mesh({0, 0, 0}, 1, 4), 1), 1)};
  scene.lights = {make_light("sky")};
  const Mean mean = mean_of(render(scene, options(48, 32, 64, 8)), "G");
  EXPECT_NEAR(mean.value, 1, 0.005);
}

// A box of albedo rho lined with lamps of radiance 1: every ray meets one lamp, so the camera
// sees the sum of rho^k for k up to max_bounces + 1.
TEST(Furnace, ClosedBoxOfLampsIsAGeometricSeries) {
  Scene scene;
  scene.camera = view({0.2, -0.1, 0.3}, {1, 0.4, 0.2}, 1.2);
  scene.objects = {object(mesh::box_mesh({Vec3d(-1), Vec3d(1)}), 0.6)};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vec3d normal(0, 0, 0);
      normal[axis] = -side;
      scene.lights.push_back(make_light("rect", {{"center", normal * -0.999},
                                                 {"normal", normal},
                                                 {"up", Vec3d(normal.y, normal.z, normal.x)},
                                                 {"width", 2.0},
                                                 {"height", 2.0}}));
    }
  for (const int bounces : {0, 3}) {
    double expected = 0;
    for (int k = 0; k <= bounces + 1; ++k) expected += std::pow(0.6, k);
    const Mean mean = mean_of(render(scene, options(40, 40, 64, bounces)), "G");
    // Rays that leave the wall between it and the lamp's edge, 0.1 % of the size away, may miss.
    EXPECT_NEAR(mean.value, expected, 4 * mean.error + 0.004 * expected) << bounces;
    EXPECT_LT(mean.error, 0.002 * expected);
  }
}

// Rays that leave a convex body meet nothing, wherever it stands: no false self-shadows.
TEST(Furnace, ConvexBodiesDoNotHitThemselves) {
  for (const Vec3d& centre : {Vec3d(0, 0, 0), Vec3d(0.02, -3, 700), Vec3d(1e4, -20, 0.5)})
    for (const double radius : {0.05, 1.0, 30.0}) {
      SCOPED_TRACE(centre.z + radius);
      Scene scene;
      scene.camera = view(centre + Vec3d(0, 0, 4 * radius), centre, 0.3);
      scene.objects = {object(mesh::sphere_mesh(centre, radius, 3), 0.5)};
      scene.lights = {make_light("sky")};
      Options o = options(48, 48, 16, 8);
      EXPECT_LT(largest_error(render(scene, o), 0.5), 1e-5);
    }
}

// Inside a closed shell of albedo rho nothing is seen, a hole is a hole.
TEST(Furnace, SealedShellStaysDark) {
  for (const bool smooth : {false, true}) {
    Scene scene;
    scene.camera = view({0.1, 0.2, 0}, {1, 0, 0.3}, 2);
    mesh::Mesh shell = mesh::sphere_mesh({0, 0, 0}, 3, 5);
    // Dents, so that rays graze and edges are sharp.
    for (size_t i = 0; i < shell.positions.size(); ++i)
      shell.positions[i] *= 1 + 0.05f * static_cast<float>((i * 7919) % 13) / 13;
    if (smooth) shell = with_radial_normals(shell, 1);
    scene.objects = {object(shell, 0.8)};
    scene.lights = {make_light("sky")};
    const Mean mean = mean_of(render(scene, options(128, 96, 32, 8)), "G");
    EXPECT_LT(mean.value, 2e-7) << "smooth " << smooth;
  }
}

}  // namespace
}  // namespace vug::render
