// SPDX-License-Identifier: Apache-2.0
// Bodies that light enters and leaves, in scenes with known results.
#include "scenes.h"

#include <vug/base/maths.h>
#include <vug/paint/kind.h>
#include <vug/render/materials/material_input.h>
#include <vug/render/paths/subsurface_walk.h>
#include <vug/render/sampling.h>

#include <gtest/gtest.h>

namespace vug::render {
namespace {

Scene in_white_sky(const NamedValues& surface, mesh::Mesh body) {
  Scene scene;
  scene.camera = view({0, 0, 4}, {0, 0, 0}, 0.3);
  scene.objects = {object(std::move(body), 1)};
  scene.objects[0].material = make_material("surface", surface);
  scene.lights = {make_light("sky")};
  return scene;
}

Mean seen(const Scene& scene, int spp, int bounces) {
  return mean_of(render(scene, options(24, 24, spp, bounces)), "G");
}

// A body without absorption looks like the uniform sky around it, whatever light does inside.
TEST(Bodies, WithoutAbsorptionVanishInAWhiteSky) {
  const Vec3d white(1, 1, 1);
  for (const double roughness : {0.1, 0.6}) {
    const Mean glass = seen(in_white_sky({{"transmission", 1.0}, {"roughness", roughness}},
                                         mesh::sphere_mesh({0, 0, 0}, 1, 4)),
                            64, 200);
    EXPECT_NEAR(glass.value, 1, 0.005 + 4 * glass.error) << "glass, roughness " << roughness;
  }
  const Mean cloud = seen(in_white_sky({{"subsurface", 1.0},
                                        {"color", white},
                                        {"mean_free_path", Number{0.3, Dimension::length}}},
                                       mesh::sphere_mesh({0, 0, 0}, 1, 4)),
                          64, 8);
  EXPECT_NEAR(cloud.value, 1, 0.005 + 4 * cloud.error) << "cloud";
}

// Straight through a slab of nearly the index of air: Beer's law, except for two faces that hardly
// reflect.
TEST(Bodies, AbsorbLightByDistance) {
  const Mean through = seen(in_white_sky({{"transmission", 1.0},
                                          {"ior", 1.01},
                                          {"roughness", 0.0},
                                          {"tint", Vec3d(0.25, 0.25, 0.25)},
                                          {"tint_depth", Number{1, Dimension::length}}},
                                         mesh::box_mesh({Vec3d(-9, -9, -0.5), Vec3d(9, 9, 0.5)})),
                            16, 20);
  EXPECT_NEAR(through.value, 0.25, 0.004);
}

// A thick body has the requested colour: van de Hulst's fit is accurate to a few percent.
TEST(Bodies, WithSubsurfaceScatteringHaveTheirColour) {
  const Vec3d color(0.6, 0.6, 0.6);
  Scene scene = in_white_sky({{"subsurface", 1.0},
                              {"color", color},
                              {"ior", 1.01},
                              {"mean_free_path", Number{0.02, Dimension::length}}},
                             mesh::box_mesh({Vec3d(-20, -20, -20), Vec3d(20, 20, 0)}));
  const Mean mean = seen(scene, 64, 0);
  EXPECT_NEAR(mean.value, 0.6, 0.03);
}

/// The walk as its definition says: a ray to the nearest surface for each free path.
bool walk_by_unlimited_rays(const PreparedScene& world, const SubsurfaceMedium& medium,
                            const Vec3f& direction, RandomStream& random, Hit& hit,
                            int& collisions) {
  const uint32_t object = hit.object;
  Ray ray{hit.behind, direction};
  for (collisions = 0;; ++collisions) {
    const auto free = static_cast<float>(-maths::log(1 - random.uniform())) * medium.mean_free_path;
    if (!world.intersect(ray, hit)) return false;
    if (hit.distance <= free) return hit.object == object && hit.surface.inside;
    ray = {ray.at(free), sample_sphere(next_pair(random))};
  }
}

// Surfaces beyond the free path make no difference, whether the body is thick or thin, and whether
// another body is in it.
TEST(Bodies, ARandomWalkEndsWhereUnlimitedRaysEndIt) {
  Scene scene = in_white_sky({{"subsurface", 1.0}}, mesh::sphere_mesh({0, 0, 0}, 1, 3));
  scene.objects.push_back(object(mesh::sphere_mesh({0.2, 0.1, 0.5}, 0.3, 2), 0.5));
  const PreparedScene world(scene);
  int exits = 0, all_collisions = 0;
  for (int i = 0; i < 400; ++i) {
    const float x = 0.02f * static_cast<float>(i % 80 - 40);
    Hit hit;
    ASSERT_TRUE(world.intersect({{x, 0.1f, 4}, {0, 0, -1}}, hit));
    // Without absorption, the walk draws no number for its survival.
    const SubsurfaceMedium medium{i % 2 ? 0.05f : 0.8f, Rgb(1.0f)};
    RandomStream one(RandomKey(static_cast<uint64_t>(i))), two = one;
    Hit expected = hit;
    int collisions = 0;
    Rgb left(1.0f);
    const bool exit = walk_by_unlimited_rays(world, medium, {0, 0, -1}, two, expected, collisions);
    if (collisions >= 32) continue;  // then the walk also draws numbers for its survival
    ASSERT_EQ(random_walk_subsurface(world, medium, {0, 0, -1}, one, hit, left), exit) << i;
    exits += exit, all_collisions += collisions;
    if (exit) {
      EXPECT_EQ(hit.surface.position, expected.surface.position) << i;
    }
  }
  EXPECT_GT(exits, 100);
  EXPECT_GT(all_collisions, 400);
}

// The light of an open body does not come from beyond the scene.
TEST(Bodies, AnOpenBodyEndsAtTheBoundsOfTheScene) {
  Scene scene = in_white_sky({{"subsurface", 1.0}, {"color", Vec3d(1, 1, 1)}}, floor_mesh(1));
  scene.camera = view({0, 4, 0.1}, {0, 0, 0}, 0.2);
  const Mean mean = seen(scene, 16, 4);
  EXPECT_LT(mean.value, 0.1);  // what the interface reflects
  EXPECT_GT(mean.value, 0.01);
}

TEST(Inputs, AreEvaluatedAtTheHit) {
  mesh::Mesh floor = floor_mesh(1);
  floor.attributes.push_back({"wet", 1, {0, 1, 1, 0}});
  floor.attributes.push_back({"Cd", 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}});
  Surface surface;
  surface.position = {0, 0, 0};
  surface.geometric_normal = surface.shading_normal = {0, 1, 0};
  surface.mesh = &floor;
  surface.triangle = 0, surface.u = 0.25f, surface.v = 0.5f;
  const SurfacePoint place(surface);
  const auto mask = make_product(paint::masks(), "attribute", {{"name", "wet"}});
  const auto color = make_product(paint::paints(), "vertex_color");
  EXPECT_NEAR(NumberInput(mask).at(place.eval_point()), paint::ramp(0.75, 0, 1), 1e-6);
  const Rgb rgb = ColorInput(color).at(place.eval_point());
  EXPECT_NEAR(rgb.x, 0.25, 1e-6);
  EXPECT_NEAR(rgb.y, 0.25, 1e-6);
  EXPECT_NEAR(rgb.z, 0.5, 1e-6);
  const auto none =
      make_product(paint::masks(), "attribute", {{"name", "dry"}, {"otherwise", 0.3}});
  EXPECT_NEAR(NumberInput(none).at(place.eval_point()), 0.3, 1e-6);
  const auto rough =
      make_product(paint::masks(), "between",
                   {{"mask", ValueTraits<paint::Mask>::write(mask)}, {"from", 0.9}, {"to", 0.1}});
  EXPECT_NEAR(NumberInput(rough).at(place.eval_point()), 0.9 - 0.8 * paint::ramp(0.75, 0, 1), 1e-6);
  const auto nan = paint::make_mask([](const paint::EvalPoint&) { return std::nan(""); });
  EXPECT_EQ(NumberInput(nan).at(place.eval_point()), 0);
}

}  // namespace
}  // namespace vug::render
