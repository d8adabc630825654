// SPDX-License-Identifier: Apache-2.0
// An instance behaves like the mesh with transformed vertices.
#include "scenes.h"

#include <vug/base/rng.h>
#include <vug/base/transform.h>
#include <vug/render/materials/material_input.h>
#include <vug/render/prepared_scene.h>
#include <vug/render/sampling.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::render {
namespace {

/// A lump without any symmetry, with vertex normals and colours.
mesh::MeshPtr lump() {
  mesh::Mesh made = mesh::sphere_mesh(Vec3d(0), 1, 3);
  mesh::Attribute colour{"Cd", 3, {}};
  for (Vec3f& p : made.positions) {
    made.normals.push_back(p);
    p = p * (1 + 0.2f * p.x * p.y + 0.1f * p.z) + Vec3f(0.3f, -0.1f, 0.2f);
    for (int c = 0; c < 3; ++c) colour.values.push_back(0.5f + 0.3f * p[c]);
  }
  made.attributes.push_back(std::move(colour));
  return std::make_shared<const mesh::Mesh>(std::move(made));
}

/// Rotated, non-uniformly scaled and sheared; far away; mirrored.
std::vector<Transform> places() {
  const Transform turn = Transform::rotation({1, 2, 3}, 1.1);
  return {turn,
          Transform::translation({3, -2, 5}) * turn * Transform::scaling({0.5, 2, 1}),
          Transform({1, 0, 0}, {0.7, 1, 0}, {0, -0.4, 0.8}, {0, 1, 0}),
          Transform::translation({500, 20, -300}) * turn * Transform::scaling(Vec3d(0.3)),
          turn * Transform::scaling({-1, 1, 1}),
          Transform::scaling({3, -0.4, 1}) * Transform::rotation({0, 1, 1}, 2)};
}

mesh::Mesh moved(const mesh::Mesh& mesh, const Transform& to) {
  mesh::Mesh out = mesh;
  for (Vec3f& p : out.positions) p = Vec3f(to.point(Vec3d(p)));
  const double turn = to.determinant() < 0 ? -1 : 1;
  for (Vec3f& n : out.normals) n = Vec3f(to.normal(Vec3d(n)).normalized());
  if (turn < 0)
    for (mesh::Triangle& t : out.triangles) std::swap(t[1], t[2]);
  return out;
}

Object placed(const mesh::MeshPtr& mesh, const Transform& place) {
  Object out;
  out.name = "instance";
  out.mesh = mesh;
  out.instance = std::make_shared<const InstanceTransform>(place);
  return out;
}

Object baked(const mesh::MeshPtr& mesh, const Transform& place) {
  Object out;
  out.name = "baked";
  out.mesh = std::make_shared<const mesh::Mesh>(moved(*mesh, place));
  return out;
}

Scene only(Object object) {
  Scene scene;
  scene.objects.push_back(std::move(object));
  return scene;
}

/// Rays through the box from all sides, and from inside it.
std::vector<Ray> rays_at(const Box3f& box, size_t count) {
  std::vector<Ray> rays;
  RandomStream random(RandomKey(7));
  const Vec3f center = box.center();
  const float size = box.size().length();
  for (size_t i = 0; i < count; ++i) {
    const auto pair = [&] {
      const auto x = static_cast<float>(random.uniform());
      return Vec2f(x, static_cast<float>(random.uniform()));
    };
    const Vec3f out = sample_sphere(pair());
    const Vec3f in = center + sample_sphere(pair()) * (0.3f * size);
    const Vec3f from = i % 4 == 0 ? center : center + out * size;
    rays.push_back({from, normalized(in - from)});
  }
  return rays;
}

TEST(Instance, IsHitLikeTheTransformedMesh) {
  const mesh::MeshPtr mesh = lump();
  for (const Transform& place : places()) {
    const PreparedScene own(only(baked(mesh, place))), world(only(placed(mesh, place)));
    const float scale = own.bounds().size().length();
    // Single precision at the instance's distance from the origin.
    const float close = 2e-6f * (scale + Vec3f(place.origin()).length());
    size_t hits = 0, other = 0;
    for (const Ray& ray : rays_at(own.bounds(), 20000)) {
      Hit a, b;
      const bool hit = own.intersect(ray, a);
      if (hit != world.intersect(ray, b) || (hit && a.triangle != b.triangle)) {
        ++other;  // at an edge
        continue;
      }
      ASSERT_EQ(world.occluded(ray, kFar), hit);
      if (!hit) continue;
      ++hits;
      const float tilt = std::fabs(dot(a.surface.geometric_normal, ray.direction));
      ASSERT_LE(length(a.surface.position - b.surface.position), close / std::max(tilt, 0.01f));
      ASSERT_EQ(a.surface.inside, b.surface.inside);
      ASSERT_GT(dot(a.surface.geometric_normal, b.surface.geometric_normal), 0.9999f);
      ASSERT_GT(dot(a.surface.shading_normal, b.surface.shading_normal), 0.999f);
      ASSERT_LT(length(a.surface.color - b.surface.color), 1e-2f);
    }
    EXPECT_GT(hits, 5000u);
    EXPECT_LT(other, 60u);
  }
}

/// From any hit point, no ray inside the closed instance escapes.
TEST(Instance, IsWatertightUnderAnyTransform) {
  const mesh::MeshPtr mesh = lump();
  for (const Transform& place : places()) {
    const PreparedScene world(only(placed(mesh, place)));
    RandomStream random(RandomKey(3));
    size_t out = 0, bounces = 0;
    Ray ray{Vec3f(place.point({0.3, -0.1, 0.2})), {0, 0, 1}};
    const Ray start = ray;
    for (; bounces < 50000; ++bounces) {
      Hit hit;
      if (!world.intersect(ray, hit) || !hit.surface.inside) {
        ++out;
        ray = start;
      } else {
        ray.origin = hit.origin;
      }
      const auto x = static_cast<float>(random.uniform());
      const Frame frame(ray.origin == start.origin ? Vec3f(0, 0, 1) : hit.surface.geometric_normal);
      ray.direction =
          frame.to_world(sample_cosine_hemisphere({x, static_cast<float>(random.uniform())}));
    }
    EXPECT_EQ(out, 0u);
  }
}

/// Means of red in stripes of the picture from left to right.
std::vector<double> stripes(const image::Image& picture) {
  constexpr int kStripes = 4;
  const auto red = static_cast<size_t>(picture.find_channel("R"));
  std::vector<double> means(kStripes);
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x)
      means[static_cast<size_t>(x * kStripes / picture.width)] +=
          static_cast<double>(picture.at(x, y, red)) * kStripes / (picture.width * picture.height);
  return means;
}

/// A floor below emissive instances, compared with emissive meshes with the same transform:
/// uniform, and brighter towards one edge.
TEST(Instance, EmissiveInstancesLightLikeTransformedMeshes) {
  mesh::Mesh square = floor_mesh(0.6f);
  square.attributes.push_back({"glow", 1, {0, 0, 1, 1}});
  const mesh::MeshPtr mesh = std::make_shared<const mesh::Mesh>(square);
  const MaterialPtr lava = make_material(
      "surface", {{"emission_radiance", 8.0},
                  {"emission_mask", ValueTraits<paint::Mask>::write(make_product(
                                        paint::masks(), "attribute", {{"name", "glow"}}))}});
  const auto picture = [&](bool instances, bool varies) {
    Scene scene;
    scene.camera = view({0, 3, 6}, {0, 0.5, 0}, 0.9);
    scene.objects.push_back(object(floor_mesh(4), 0.5));
    // Facing down: rotated, and mirrored, which keeps the outside of a solid outside.
    for (const Transform& place :
         {Transform::translation({-1.2, 0.7, 0}) * Transform::rotation({1, 0, 0}, kPi),
          Transform::translation({1, 0.6, 0}) * Transform::scaling({2, -1, 0.5})}) {
      Object light = instances ? placed(mesh, place) : baked(mesh, place);
      if (varies)
        light.material = lava;
      else
        light.emission = Rgb(5, 4, 3);
      scene.objects.push_back(light);
    }
    return stripes(render(scene, options(64, 48, 256, 1)));
  };
  for (const bool varies : {false, true}) {
    const std::vector<double> instanced = picture(true, varies),
                              moved_mesh = picture(false, varies);
    for (size_t i = 0; i < instanced.size(); ++i) {
      EXPECT_GT(moved_mesh[i], 0.03);
      EXPECT_NEAR(instanced[i], moved_mesh[i], 0.01 * moved_mesh[i]) << varies << " stripe " << i;
    }
  }
}

TEST(Instance, MovingEmissiveInstancesAreRejected) {
  Object light = placed(std::make_shared<const mesh::Mesh>(floor_mesh(1)), Transform());
  light.instance = std::make_shared<const InstanceTransform>(
      std::vector<Transform>{Transform(), Transform::translation({1, 0, 0})});
  light.emission = Rgb(1);
  EXPECT_THROW(PreparedScene(only(light)), Error);
}

/// Masks are evaluated in the mesh's own space or in world space.
TEST(Instance, MaterialsUseOwnOrWorldSpace) {
  Object piece = placed(std::make_shared<const mesh::Mesh>(floor_mesh(1)),
                        Transform::translation({0, 3, 0}) * Transform::scaling(Vec3d(2)));
  for (const bool by_place : {false, true}) {
    piece.world_space_material = by_place;
    const PreparedScene world(only(piece));
    Hit hit;
    ASSERT_TRUE(world.intersect({{0.3f, 10, 0.2f}, {0, -1, 0}}, hit));
    hit.surface.footprint = 0.5f;
    SurfacePoint place(hit.surface);
    EXPECT_NEAR(place.eval_point().position.y, by_place ? 3 : 0, 1e-6);
    EXPECT_NEAR(place.eval_point().position.x, by_place ? 0.3 : 0.15, 1e-6);
    EXPECT_NEAR(place.eval_point().footprint, by_place ? 0.5 : 0.25, 1e-6);
    place.move_to({1, 3, 0});
    const Vec3d there(by_place ? 1 : 0.5, by_place ? 3 : 0, 0);
    EXPECT_NEAR((place.eval_point().position - there).length(), 0, 1e-6);
  }
}

TEST(Instance, ManyOfOneMeshTakeLittleMemory) {
  const mesh::MeshPtr mesh = lump();
  Scene one = only(placed(mesh, Transform())), many = one;
  for (int i = 0; i < 999; ++i) many.objects.push_back(one.objects[0]);
  const Options small = options(8, 8, 1, 1);
  const double tree = memory_estimate(one, small), all = memory_estimate(many, small);
  EXPECT_LT(all - tree, 999 * 2000.0);
}

TEST(InstanceTransform, InterpolatesItsKeyframes) {
  const InstanceTransform instance(
      {Transform(), Transform::translation({2, 0, 0}),
       Transform::translation({2, 4, 0}) * Transform::scaling(Vec3d(3))});
  EXPECT_EQ(instance.at(0).origin, Vec3f(0.0f));
  EXPECT_EQ(instance.at(0.25f).origin, Vec3f(1, 0, 0));
  EXPECT_EQ(instance.at(0.75f).origin, Vec3f(2, 2, 0));
  EXPECT_EQ(instance.at(0.75f).x, Vec3f(2, 0, 0));
  EXPECT_EQ(instance.at(1).origin, Vec3f(2, 4, 0));
  const Vec3d back = instance.inverse(0.75f).point({4, 4, 2});
  EXPECT_NEAR((back - Vec3d(1, 1, 1)).length(), 0, 1e-6);
}

}  // namespace
}  // namespace vug::render
