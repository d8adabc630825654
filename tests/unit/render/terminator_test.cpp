// SPDX-License-Identifier: Apache-2.0
// Coarse meshes with smooth normals are lit like the smooth surface that they approximate.
#include "scenes.h"
#include "surface_scenes.h"

#include <gtest/gtest.h>

namespace vug::render {
namespace {

constexpr float kAlbedo = 0.8f;
const Vec3f kToSun(0.99619470f, 0.08715574f, 0);  // at 5 degrees

/// Radius 1, 80 triangles.
Object coarse_ball() {
  return object(with_radial_normals(mesh::sphere_mesh({0, 0, 0}, 1, 1), 1), kAlbedo);
}

/// Triangles that face away from the sun, or are hidden by others, with smooth normals that face
/// it.
void expect_smooth_terminator(Object ball, float tolerance) {
  Scene scene = only(std::move(ball));
  scene.camera = view({0, 0, 8}, {0, 0, 0}, 0.26);
  scene.lights = {make_light("sun", {{"elevation", radians(kPi / 36)},
                                     {"azimuth", radians(kPi / 2)},
                                     {"irradiance", Vec3d(3)},
                                     {"angle", radians(0.001)}})};
  const int size = 96;
  const image::Image picture = render(scene, options(size, size, 4, 1));
  const auto green = static_cast<size_t>(picture.find_channel("G"));
  const PreparedScene world(scene);
  size_t grazed = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Vec2f film{(static_cast<float>(x) + 0.5f) / size,
                       (static_cast<float>(y) + 0.5f) / size};
      Hit hit;
      if (!world.intersect(scene.camera->ray(film, 1, {0.5f, 0.5f}), hit)) continue;
      const Vec3f& normal = hit.surface.shading_normal;
      if (normal.z < 0.5f) continue;  // near the rim of the ball
      const float cosine = dot(normal, kToSun);
      grazed += cosine > 0 && cosine < 0.2f;
      const float seen =
          picture.pixels[static_cast<size_t>(y * size + x) * picture.channels.size() + green];
      ASSERT_NEAR(seen, 3 * kAlbedo / kPif * std::max(0.0f, cosine), tolerance) << x << ' ' << y;
    }
  EXPECT_GT(grazed, 300u);
}

TEST(Terminator, FollowsTheSmoothNormals) { expect_smooth_terminator(coarse_ball(), 0.02f); }

TEST(Terminator, FollowsASmoothLevelSet) {
  Object ball = traced(vug::render::ball());
  ball.material = make_material("lambert", {{"albedo", Vec3d(kAlbedo)}});
  expect_smooth_terminator(std::move(ball), 0.02f);
}

// Reflected light also leaves below the triangle's horizon; none is lost in a uniform sky.
TEST(Terminator, KeepsAllLightOfAUniformSky) {
  Scene scene = only(coarse_ball());
  scene.camera = view({0, 0, 8}, {0, 0, 0}, 0.1);
  scene.lights = {make_light("sky")};
  const Mean mean = mean_of(render(scene, options(32, 32, 256, 4)), "G");
  EXPECT_NEAR(mean.value, kAlbedo, 4 * mean.error + 5e-4);
  EXPECT_LT(mean.error, 1e-3);
}

/// Every third normal is flipped, as where a mesh is thinner than a voxel.
mesh::Mesh with_wrong_normals(mesh::Mesh mesh) {
  mesh = with_radial_normals(std::move(mesh), 1);
  for (size_t i = 0; i < mesh.normals.size(); i += 3) mesh.normals[i] = -mesh.normals[i];
  return mesh;
}

TEST(Terminator, NormalsThroughTheirTrianglesLeakNoLight) {
  Scene scene = only(object(with_wrong_normals(mesh::sphere_mesh({0, 0, 0}, 3, 3)), 0.8));
  scene.camera = view({0.1, 0.2, 0}, {1, 0, 0.3}, 2);
  scene.lights = {make_light("sky")};
  EXPECT_EQ(mean_of(render(scene, options(64, 48, 16, 8)), "G").value, 0);
}

TEST(Terminator, KeepsAllLightWithSuchNormals) {
  Scene scene = only(object(with_wrong_normals(mesh::sphere_mesh({0, 0, 0}, 1, 2)), kAlbedo));
  scene.camera = view({0, 0, 8}, {0, 0, 0}, 0.1);
  scene.lights = {make_light("sky")};
  const Mean mean = mean_of(render(scene, options(32, 32, 256, 4)), "G");
  EXPECT_NEAR(mean.value, kAlbedo, 4 * mean.error + 5e-4);
}

}  // namespace
}  // namespace vug::render
