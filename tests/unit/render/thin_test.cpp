// SPDX-License-Identifier: Apache-2.0
// Sheets without a body: lit from behind, in furnaces, and as panes.
#include "scenes.h"

#include <gtest/gtest.h>

namespace vug::render {
namespace {

MaterialPtr thin(NamedValues more) {
  more.emplace_back("thin", true);
  return make_material("surface", more);
}

/// Radiance of a sheet at the origin that a square light of radiance 1 lights from 60 cm above or
/// below, by the midpoint rule.
double quadrature_of_light(const MaterialPtr& material, float side, const Vec3f& out,
                           bool inside = false) {
  constexpr int kSteps = 600;
  Surface surface;
  surface.geometric_normal = surface.shading_normal = {0, inside ? -1.0f : 1.0f, 0};
  surface.inside = inside;
  const Frame frame(surface.shading_normal);
  BsdfMemory memory;
  const Bsdf& bsdf = material->at(surface, frame.to_local(out), memory);
  double sum = 0;
  for (int j = 0; j < kSteps; ++j)
    for (int i = 0; i < kSteps; ++i) {
      const Vec3f at((static_cast<float>(i) + 0.5f) / kSteps - 0.5f, 0.6f * side,
                     (static_cast<float>(j) + 0.5f) / kSteps - 0.5f);
      const float squared = dot(at, at);
      const Vec3f in = at * (1 / std::sqrt(squared));
      sum += static_cast<double>(bsdf.evaluate(frame.to_local(in)).total().x * std::fabs(in.y) /
                                 squared);
    }
  return sum / (kSteps * kSteps);
}

TEST(Thin, IsLitFromBothSides) {
  const Vec3f out = normalized(Vec3f(0.3f, 0.4f, 0));
  const MaterialPtr sheets[] = {
      thin({{"subsurface", 1.0}, {"through", 0.7}, {"color", Vec3d(0.8)}}),
      thin({{"transmission", 1.0}, {"roughness", 0.5}, {"through_color", Vec3d(0.6)}}),
      thin({{"transmission", 0.4}, {"subsurface", 0.8}, {"roughness", 0.35}, {"coat", 0.2}})};
  for (const MaterialPtr& material : sheets)
    for (const float side : {1.0f, -1.0f}) {
      Scene scene;
      scene.camera = view(Vec3d(out), {0, 0, 0}, 1e-3);
      scene.objects = {object(floor_mesh(0.01f), 1)};
      scene.objects[0].material = material;
      scene.lights = {make_light("rect", {{"center", Vec3d(0, static_cast<double>(0.6f * side), 0)},
                                          {"normal", Vec3d(0, static_cast<double>(-side), 0)},
                                          {"width", 1.0},
                                          {"height", 1.0},
                                          {"visible", false}})};
      const Mean mean = mean_of(render(scene, options(32, 32, 64, 0)), "R");
      const double expected = quadrature_of_light(material, side, out);
      EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-3 * expected);
      // Lights behind the sheet are sampled, too: BSDF sampling alone has ten times that error.
      EXPECT_LT(mean.error, 0.01 * expected);
      EXPECT_GT(expected, 0.01);
    }
}

// From inside a rough clear body, lights outside are sampled, not only hit by chance.
TEST(Thin, LightsBehindARoughFaceAreSampled) {
  const Vec3f out = normalized(Vec3f(0.3f, -0.4f, 0));
  const MaterialPtr glass =
      make_material("surface", {{"transmission", 1.0}, {"roughness", 0.5}, {"ior", 1.33}});
  Scene scene;
  scene.camera = view(Vec3d(out), {0, 0, 0}, 1e-3);
  scene.objects = {object(floor_mesh(0.01f), 1)};
  scene.objects[0].material = glass;
  scene.lights = {make_light("rect", {{"center", Vec3d(0, 0.6, 0)},
                                      {"normal", Vec3d(0, -1, 0)},
                                      {"width", 1.0},
                                      {"height", 1.0},
                                      {"visible", false}})};
  const double expected = quadrature_of_light(glass, 1, out, true);
  const Mean mean = mean_of(render(scene, options(32, 32, 64, 0)), "R");
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-3 * expected);
  EXPECT_LT(mean.error, 0.01 * expected);
  EXPECT_GT(expected, 0.01);
}

TEST(Thin, WhiteSheetsVanishInAWhiteSky) {
  Scene scene;
  scene.camera = view({0.2, 1, 0.5}, {0, 0, 0}, 0.5);
  scene.lights = {make_light("sky")};
  const NamedValues shares[] = {{{"subsurface", 1.0}, {"through", 0.4}},
                                {{"transmission", 0.8}, {"roughness", 0.4}},
                                {{"subsurface", 0.5}, {"transmission", 0.3}, {"fuzz", 0.5}}};
  float height = 0;
  for (NamedValues more : shares) {
    more.emplace_back("color", Vec3d(1));
    Object sheet = object(at_height(floor_mesh(1), height), 1);
    sheet.material = thin(more);
    scene.objects.push_back(sheet);
    height -= 0.3f;
  }
  Options o = options(24, 24, 64, 400);
  o.openings = false;
  const Mean mean = mean_of(render(scene, o), "G");
  EXPECT_NEAR(mean.value, 1, 4 * mean.error + 0.003);
  EXPECT_LT(mean.error, 3e-3);
}

// At normal incidence a smooth pane transmits the sum of the series of reflections between its
// faces.
TEST(Thin, PaneTransmitsTheSeriesOfItsFaces) {
  Scene scene;
  scene.camera = view({0, 1, 0}, {0, 0, 0}, 0.01, {0, 0, 1});
  Object light = object(at_height(floor_mesh(5), -0.5f), 0);
  light.emission = Rgb(1);
  Object pane = object(floor_mesh(1), 1);
  pane.material = thin({{"transmission", 1.0}, {"roughness", 0.0}, {"ior", 1.5}});
  scene.objects = {pane, light};
  const Mean mean = mean_of(render(scene, options(16, 16, 256, 2)), "G");
  const double face = 0.04, expected = (1 - face) * (1 - face) / (1 - face * face);
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + 1e-3);
  EXPECT_LT(mean.error, 5e-3);
}

TEST(Thin, CannotBeMixedWithBodies) {
  const auto value = [](const MaterialPtr& m) { return ValueTraits<MaterialPtr>::write(m); };
  EXPECT_THROW(
      make_material("mix", {{"a", value(thin({}))}, {"b", value(make_material("lambert"))}}),
      Error);
  EXPECT_TRUE(make_material("mix", {{"a", value(thin({}))}, {"b", value(thin({}))}})->thin());
}

}  // namespace
}  // namespace vug::render
