// SPDX-License-Identifier: Apache-2.0
// White furnace tests: the sum of all reflections is known.
#include "scenes.h"

#include <vug/base/rng.h>
#include <vug/render/prepared_scene.h>

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

// A convex body that reflects all light looks like the sky around it.
TEST(Furnace, WhiteSphereVanishesInAWhiteSky) {
  Scene scene;
  scene.camera = view({0, 0, 4}, {0, 0, 0}, 0.9);
  scene.objects = {object(mesh::sphere_mesh({0, 0, 0}, 1, 4), 1)};
  scene.lights = {make_light("sky")};
  EXPECT_LT(largest_error(render(scene, options(48, 32, 16, 8)), 1), 1e-5);
}

// With smooth normals some directions are below the actual surface and are lost, but few.
TEST(Furnace, SmoothNormalsLoseLittle) {
  Scene scene;
  scene.camera = view({0, 0, 4}, {0, 0, 0}, 0.4);
  scene.objects = {object(with_radial_normals(mesh::sphere_mesh({0, 0, 0}, 1, 4), 1), 1)};
  scene.lights = {make_light("sky")};
  const Mean mean = mean_of(render(scene, options(48, 32, 64, 8)), "G");
  EXPECT_NEAR(mean.value, 1, 0.005);
}

// A box of albedo rho lined with lights of radiance 1: every ray hits one light, so the camera sees
// the sum of rho^k for k up to max_bounces + 1.
TEST(Furnace, ClosedBoxOfLightsIsAGeometricSeries) {
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
    // Rays that leave the wall between it and the light's edge, 0.1 % of the size away, may miss.
    EXPECT_NEAR(mean.value, expected, 4 * mean.error + 0.004 * expected) << bounces;
    EXPECT_LT(mean.error, 0.002 * expected);
  }
}

// Rays that leave a convex body hit nothing, at any position: no false self-shadowing.
TEST(Furnace, ConvexBodiesDoNotHitThemselves) {
  const std::pair<Vec3d, double> bodies[] = {
      {{0, 0, 0}, 0.05}, {{0, 0, 0}, 1}, {{0.02, -3, 700}, 30}, {{1e4, -20, 0.5}, 1000}};
  for (const auto& [center, radius] : bodies) {
    SCOPED_TRACE(radius);
    Scene scene;
    scene.camera = view(center + Vec3d(0, 0, 4 * radius), center, 0.3);
    scene.objects = {object(mesh::sphere_mesh(center, radius, 3), 0.5)};
    scene.lights = {make_light("sky")};
    Options o = options(48, 48, 16, 8);
    o.integrator = make_integrator("path", {{"roulette", Value::Name{"off"}}});
    EXPECT_LT(largest_error(render(scene, o), 0.5), 1e-5);
  }
}

/// A closed shell with sharp dents, with grazing rays and acute corners.
mesh::Mesh dented_shell() {
  mesh::Mesh shell = mesh::sphere_mesh({0, 0, 0}, 3, 5);
  for (size_t i = 0; i < shell.positions.size(); ++i)
    shell.positions[i] *= 1 + 0.05f * static_cast<float>((i * 7919) % 13) / 13;
  return shell;
}

// Inside a sealed shell the sky is invisible. Single rays may still pass exactly through a vertex:
// 2e-7 of the camera's samples, so 400,000 samples contain at most two (p = 1e-4).
TEST(Furnace, SealedShellStaysDark) {
  for (const bool smooth : {false, true}) {
    Scene scene;
    scene.camera = view({0.1, 0.2, 0}, {1, 0, 0.3}, 2);
    scene.objects = {object(dented_shell(), 0.8)};
    if (smooth) scene.objects = {object(with_radial_normals(dented_shell(), 1), 0.8)};
    scene.lights = {make_light("sky")};
    const image::Image picture = render(scene, options(128, 96, 32, 8));
    int leaks = 0;
    for (size_t i = 0; i < picture.pixels.size(); i += picture.channels.size())
      if (picture.pixels[i] > 0) ++leaks;
    EXPECT_LE(leaks, 2) << "smooth " << smooth;
  }
}

// Rays aimed at points on edges: a traversal that is not watertight misses some of them.
TEST(Furnace, EdgesAreTight) {
  Scene scene;
  scene.objects = {object(dented_shell(), 0.8)};
  const PreparedScene world(scene);
  const mesh::Mesh& shell = *scene.objects[0].mesh;
  RandomStream random(RandomKey(4));
  int through = 0;
  for (int i = 0; i < 500000; ++i) {
    const mesh::Triangle& t =
        shell.triangles[random.below(static_cast<uint32_t>(shell.triangles.size()))];
    const auto u = static_cast<float>(random.uniform());
    const Vec3f at = shell.positions[t[0]] * (1 - u) + shell.positions[t[1]] * u;
    const Vec3f from(0.3f, static_cast<float>(random.uniform()), -0.2f);
    if (!world.occluded({from, normalized(at - from)}, kFar)) ++through;
  }
  EXPECT_LE(through, 2);
}

}  // namespace
}  // namespace vug::render
