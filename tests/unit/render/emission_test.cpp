// SPDX-License-Identifier: Apache-2.0
// Materials of varying emission, against quadrature.
#include "scenes.h"

#include <vug/paint/kind.h>
#include <vug/render/prepared_scene.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

using Pattern = std::function<double(const Vec3d&)>;

MaterialPtr shining(const Pattern& pattern, double radiance) {
  const paint::Mask mask =
      paint::make_mask([pattern](const paint::EvalPoint& s) { return pattern(s.position); });
  return make_material("surface", {{"color", Vec3d(0)},
                                   {"specular", 0.0},
                                   {"emission", Vec3d(1, 0.5, 0.25)},
                                   {"emission_mask", ValueTraits<paint::Mask>::write(mask)},
                                   {"emission_radiance", radiance}});
}

/// A square ceiling of cells x cells pairs of triangles that faces down.
mesh::Mesh ceiling_mesh(float half, float height, int cells) {
  mesh::Mesh mesh;
  const auto at = [&](int i) {
    return half * (2 * static_cast<float>(i) / static_cast<float>(cells) - 1);
  };
  for (int z = 0; z <= cells; ++z)
    for (int x = 0; x <= cells; ++x) mesh.positions.push_back({at(x), height, at(z)});
  const auto vertex = [&](int x, int z) { return static_cast<uint32_t>(z * (cells + 1) + x); };
  for (int z = 0; z < cells; ++z)
    for (int x = 0; x < cells; ++x) {
      mesh.triangles.push_back({vertex(x, z), vertex(x + 1, z), vertex(x + 1, z + 1)});
      mesh.triangles.push_back({vertex(x, z), vertex(x + 1, z + 1), vertex(x, z + 1)});
    }
  return mesh;
}

Scene under(const mesh::Mesh& panel, const MaterialPtr& material, const MaterialPtr& floor) {
  Scene scene;
  scene.camera = view({0.2, 0.15, 0.05}, {0, 0, 0}, 1e-3);
  scene.objects = {object(floor_mesh(0.01f), 1), object(panel, 0)};
  if (floor) scene.objects[0].material = floor;
  scene.objects[1].material = material;
  return scene;
}

/// Radiance of the floor at the origin as the camera sees it, by the midpoint rule over the
/// ceiling.
double quadrature(const MaterialPtr& floor, double half, double height, const Pattern& pattern) {
  constexpr int kSteps = 1500;
  Surface surface;
  surface.geometric_normal = surface.shading_normal = {0, 1, 0};
  const Frame frame(surface.shading_normal);
  const Vec3f out = normalized(Vec3f(0.4f, 0.3f, 0.1f));
  BsdfMemory memory;
  const Bsdf& bsdf = floor->at(surface, frame.to_local(out), memory);
  double sum = 0;
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i) {
      const Vec3d at(half * (2 * (i + 0.5) / kSteps - 1), height,
                     half * (2 * (j + 0.5) / kSteps - 1));
      const double light = pattern(at);
      if (!(light > 0)) continue;
      const double squared = at.dot(at);
      const Vec3f in(at / std::sqrt(squared));
      sum +=
          light * static_cast<double>(bsdf.evaluate(frame.to_local(in)).total().x * in.y) / squared;
    }
  return sum * 4 * half * half / (kSteps * kSteps);
}

double striped_emission(const Vec3d& p) {
  const double place = 5 * p.x + 2 * p.z;
  return place - std::floor(place) < 0.3 ? 0.2 + 0.8 * (0.5 + 0.5 * p.z) : 0;
}

// Light is found by choosing triangles and by following the surface's directions, on a matte floor
// mostly the one way and on a polished one the other; near and far, on few triangles and on many
// of which most are dark.
TEST(Emission, VaryingCeilingMatchesQuadrature) {
  const MaterialPtr floors[] = {make_material("lambert", {{"albedo", Vec3d(1)}}),
                                make_material("surface", {{"metal", 1.0}, {"roughness", 0.35}})};
  for (const MaterialPtr& floor : floors)
    for (const double height : {0.3, 20.0})
      for (const int cells : {1, 24}) {
        SCOPED_TRACE("height " + std::to_string(height) + ", cells " + std::to_string(cells));
        const double expected = 3 * quadrature(floor, 1, height, striped_emission);
        const Scene scene = under(ceiling_mesh(1, static_cast<float>(height), cells),
                                  shining(striped_emission, 3), floor);
        const Mean mean = mean_of(render(scene, options(32, 32, 256, 0)), "R");
        EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-3 * expected);
        EXPECT_LT(mean.error, 0.01 * expected);
        EXPECT_GT(expected, 0);
      }
}

TEST(Emission, IsVisibleFromItsFrontOnly) {
  const auto seen = [](double from) {
    Scene scene =
        under(ceiling_mesh(1, 1, 3), shining([](const Vec3d& p) { return p.x > 0; }, 4), {});
    scene.camera = view({0.5, from, 0.2}, {0.5, 1, 0.2}, 0.1, {0, 0, 1});
    return render(scene, options(4, 4, 4, 0));
  };
  const image::Image below = seen(0), above = seen(2);
  for (size_t i = 0; i < below.pixels.size(); i += below.channels.size()) {
    EXPECT_FLOAT_EQ(below.pixels[i], 4);
    EXPECT_FLOAT_EQ(below.pixels[i + 1], 2);
    EXPECT_FLOAT_EQ(below.pixels[i + 2], 1);
    EXPECT_EQ(above.pixels[i], 0);
  }
}

double spot(const Vec3d& p) {
  return std::max(0.0, 1 - Vec2d(p.x - 0.613, p.z + 0.27).length2() / (0.03 * 0.03));
}

/// Number of triangles of a mesh under that pattern that can be chosen as lights.
size_t chosen(int cells) {
  const Scene scene = under(ceiling_mesh(1, 0.4f, cells), shining(spot, 500), {});
  return LightSet(scene.lights, scene.objects).size();
}

// A spot between all points at which the triangles were evaluated is in no tree, and yet its light
// arrives, on surfaces and through haze.
TEST(Emission, OfTrianglesOutsideTheTreeIsNotLost) {
  ASSERT_EQ(chosen(1), 0u);
  ASSERT_GT(chosen(200), 0u);
  const MaterialPtr floor = make_material("lambert", {{"albedo", Vec3d(1)}});
  const double expected = 500 * quadrature(floor, 1, 0.4, spot);
  for (const int cells : {1, 200}) {
    const Scene scene = under(ceiling_mesh(1, 0.4f, cells), shining(spot, 500), floor);
    const Mean mean = mean_of(render(scene, options(32, 32, cells == 1 ? 2048 : 256, 0)), "R");
    EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-3 * expected) << cells;
    EXPECT_LT(mean.error, 0.05 * expected);
  }
  const auto hazy = [](int cells) {
    Scene scene = under(ceiling_mesh(1, 0.4f, cells), shining(spot, 500), {});
    scene.medium =
        make_medium("haze", {{"extinction", 0.5}, {"center", Vec3d(0)}, {"size", Vec3d(2)}});
    scene.camera = view({0.9, 0.1, 0}, {0, 0.1, 0}, 0.4);
    return mean_of(render(scene, options(48, 48, cells == 1 ? 512 : 64, 1)), "R");
  };
  const Mean few = hazy(1), many = hazy(200);
  // The pixels see different parts; their spread is an upper bound of the error.
  EXPECT_NEAR(few.value, many.value, 4 * std::hypot(few.error, many.error));
  EXPECT_GT(many.value, 10 * many.error);
}

TEST(Emission, OfMixedMaterialsIsMixed) {
  const auto value = [](const MaterialPtr& m) { return ValueTraits<MaterialPtr>::write(m); };
  const MaterialPtr bright = make_material("surface", {{"emission_radiance", 8.0}});
  const MaterialPtr dark = make_material("lambert");
  EXPECT_FALSE(dark->is_emissive());
  const MaterialPtr mixed =
      make_material("mix", {{"a", value(dark)}, {"b", value(bright)}, {"mask", 0.25}});
  EXPECT_TRUE(mixed->is_emissive());
  EXPECT_FLOAT_EQ(mixed->emission({}).x, 2);
  EXPECT_FALSE(make_material("surface", {{"emission_radiance", 8.0}, {"emission", Vec3d(0)}})
                   ->is_emissive());
}

}  // namespace
}  // namespace vug::render
