// SPDX-License-Identifier: Apache-2.0
// A level set without a mesh: as an instance, in motion, and in pictures compared with its mesh.
#include "surface_scenes.h"

#include <vug/base/transform.h>
#include <vug/meshing/polygonize.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::render {
namespace {

std::vector<Transform> two_transforms() {
  const Transform turn = Transform::rotation({1, 2, 3}, 1.1);
  return {turn, Transform::translation({3, -2, 5}) * turn * Transform::scaling({0.5, 2, 1}),
          Transform::translation({500, 20, -300}) * turn * Transform::scaling(Vec3d(0.3)),
          Transform::scaling({3, -0.4, 1}) * Transform::rotation({0, 1, 1}, 2)};
}

Object moving_object(Object object, std::vector<Transform> way) {
  object.instance = std::make_shared<const InstanceTransform>(std::move(way));
  return object;
}

/// In the instance's own space, its ball is a ball.
TEST(InstancedSurface, InstancesAreHitAtTheirTransform) {
  const Object own = traced(ball());
  for (const Transform& place : two_transforms()) {
    const PreparedScene world(only(moving_object(own, {place})));
    const Transform back = place.inverse();
    RandomStream random(RandomKey(7));
    const auto reach = static_cast<float>(3 * place.max_stretch());
    const double close = 1e-3 + 1e-5 * (1 + place.origin().length()) / place.min_stretch();
    size_t hits = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3f from = Vec3f(place.origin()) + sample_sphere(pair(random)) * reach;
      const Vec3f to(place.point(
          Vec3d(sample_sphere(pair(random)) * (0.9f * static_cast<float>(random.uniform())))));
      Hit hit;
      const Ray ray{from, normalized(to - from)};
      ASSERT_TRUE(world.intersect(ray, hit));
      ASSERT_TRUE(world.occluded(ray, kFar));
      ++hits;
      ASSERT_FALSE(hit.surface.inside);
      const Vec3d there = back.point(Vec3d(hit.surface.position));
      ASSERT_NEAR(there.length(), 1, close);
      const Vec3d normal = place.normal(there).normalized();
      ASSERT_GT(Vec3d(hit.surface.geometric_normal).dot(normal), 0.98);
      ASSERT_GT(Vec3d(hit.surface.shading_normal).dot(normal), 0.995);
    }
    EXPECT_GT(hits, 0u);
  }
}

/// Number of steps of a random walk inside that end outside.
size_t leaks(const PreparedScene& world, const Vec3f& from, int steps) {
  RandomStream random(RandomKey(3));
  const Ray start{from, {0, 0, 1}};
  Ray ray = start;
  size_t out = 0;
  for (int step = 0; step < steps; ++step) {
    Hit hit;
    if (!world.intersect(ray, hit) || !hit.surface.inside) {
      ++out;
      ray = start;
      continue;
    }
    ray.origin = hit.origin;
    ray.direction =
        Frame(hit.surface.geometric_normal).to_world(sample_cosine_hemisphere(pair(random)));
  }
  return out;
}

render::Object meshed(const field::Field& solid) {
  render::Object out;
  out.name = "meshed";
  out.mesh = std::make_shared<const mesh::Mesh>(meshing::polygonize(level_set(solid), &solid).mesh);
  return out;
}

/// A lump is watertight under any transform. In sharp valleys rays start closer to the opposite
/// wall than single precision can resolve there: some escape, but fewer than with a mesh.
TEST(InstancedSurface, InstancesAreTight) {
  const render::Object smooth = traced(lump()), sharp = traced(rough()), mesh = meshed(rough());
  for (const Transform& place : two_transforms()) {
    const auto lost = [&](const render::Object& object, int steps) {
      return leaks(PreparedScene(only(moving_object(object, {place}))), Vec3f(place.origin()),
                   steps);
    };
    EXPECT_EQ(lost(smooth, 100000), 0u) << place.origin().x;
    EXPECT_LT(4 * lost(sharp, 100000), lost(mesh, 100000)) << place.origin().x;
  }
}

TEST(InstancedSurface, MovesWhileTheShutterIsOpen) {
  const PreparedScene world(
      only(moving_object(traced(ball()), {Transform(), Transform::translation({4, 0, 0})})));
  EXPECT_TRUE(world.moves());
  for (const float time : {0.0f, 0.25f, 1.0f}) {
    const PreparedScene now = world.at(time);
    Hit hit;
    ASSERT_TRUE(now.intersect({{4 * time, 0, 5}, {0, 0, -1}}, hit));
    EXPECT_NEAR(hit.distance, 4, 1e-3);
    EXPECT_NEAR(hit.surface.position.x, 4 * time, 1e-5);
    EXPECT_FALSE(now.intersect({{4 * time - 1.1f, 0, 5}, {0, 0, -1}}, hit));
  }
}

/// On a floor under a sky and a light, the picture without the mesh is the same. Both use the same
/// samples, so only the noise of paths remains that diverge where the surfaces differ by
/// thousandths of a voxel. The lump has no creases, which the mesh would keep sharper.
TEST(InstancedSurface, LooksLikeItsMesh) {
  const field::Field solid = lump();
  const auto picture = [&](bool direct) {
    Scene scene;
    scene.camera = view({0, 1, 4.5}, {0, 0, 0}, 0.6);
    scene.lights = {
        make_light("sky", {{"radiance", Vec3d(0.3, 0.4, 0.5)}}),
        make_light("sphere",
                   {{"center", Vec3d(3, 3, 3)}, {"radius", 0.3}, {"radiance", Vec3d(60, 50, 40)}})};
    const render::Object rock = direct ? traced(solid) : meshed(solid);
    scene.objects = {rock, object(floor_mesh(4), 0.5)};
    return render(scene, options(64, 48, 256, 3));
  };
  const image::Image direct = picture(true), meshed = picture(false);
  const double mean = mean_of(direct, "G").value, other = mean_of(meshed, "G").value;
  EXPECT_NEAR(mean, other, 0.001 * other);
  const auto channel = [](const image::Image& image, const char* name) {
    return static_cast<size_t>(image.find_channel(name));
  };
  double squares = 0, variance = 0, turned = 0;
  for (int y = 0; y < direct.height; ++y)
    for (int x = 0; x < direct.width; ++x) {
      const auto read = [&](const image::Image& image, const char* name) {
        return static_cast<double>(image.at(x, y, channel(image, name)));
      };
      squares += std::pow(read(direct, "G") - read(meshed, "G"), 2);
      variance += read(direct, "variance.G") + read(meshed, "variance.G");
      turned = std::max(turned, std::fabs(read(direct, "N.X") - read(meshed, "N.X")));
    }
  EXPECT_LT(squares, variance);
  EXPECT_LT(turned, 0.05);
}

}  // namespace
}  // namespace vug::render
