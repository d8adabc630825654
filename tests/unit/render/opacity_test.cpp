// SPDX-License-Identifier: Apache-2.0
// Holes and partial coverage: what camera and shadow rays hit, in closed form.
#include "scenes.h"

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/paint/kind.h>

namespace vug::render {
namespace {

Value as_mask(std::function<double(const paint::EvalPoint&)> f) {
  return ValueTraits<paint::Mask>::write(paint::make_mask(std::move(f)));
}
MaterialPtr black(const Value& opacity) {
  return make_material("surface", {{"color", Vec3d(0)}, {"specular", 0.0}, {"opacity", opacity}});
}
/// A light of radiance 1 below, seen from above through `sheets` of the material.
Scene over_a_light(const MaterialPtr& material, int sheets) {
  Scene scene;
  scene.camera = view({0, 3, 0}, {0, 0, 0}, 0.2, {0, 0, 1});
  Object light = object(at_height(floor_mesh(5), -0.5f), 0);
  light.emission = Rgb(1);
  scene.objects = {light};
  for (int i = 0; i < sheets; ++i) {
    Object sheet = object(at_height(floor_mesh(1), 0.2f * static_cast<float>(i)), 1);
    sheet.material = material;
    scene.objects.push_back(sheet);
  }
  return scene;
}

TEST(Opacity, TransmitsTheUncoveredPart) {
  for (const int sheets : {1, 2}) {
    const Mean seen =
        mean_of(render(over_a_light(black(0.3), sheets), options(32, 32, 64, 0)), "G");
    const double expected = sheets == 1 ? 0.7 : 0.49;
    EXPECT_NEAR(seen.value, expected, 4 * seen.error);
    EXPECT_LT(seen.error, 0.005);
  }
}

TEST(Opacity, ShadowsHaveTheSameHoles) {
  Scene scene;
  scene.camera = view({0, 0.5, 0}, {0, 0, 0}, 1, {0, 0, 1});
  scene.objects = {object(floor_mesh(1), 0.8)};
  scene.lights = {make_light(
      "rect",
      {{"center", Vec3d(0, 4, 0)}, {"normal", Vec3d(0, -1, 0)}, {"width", 2.0}, {"height", 2.0}})};
  const Options o = options(32, 32, 64, 0);
  const Mean bright = mean_of(render(scene, o), "G");
  Object sheet = object(at_height(floor_mesh(4), 2), 1);
  sheet.material = black(0.6);
  scene.objects.push_back(sheet);
  const Mean dim = mean_of(render(scene, o), "G");
  const double error = 4 * (dim.error / bright.value + bright.error / bright.value);
  EXPECT_NEAR(dim.value / bright.value, 0.4, error);
  EXPECT_LT(error, 0.02);
}

TEST(Opacity, MasksCutSharpEdges) {
  const auto right =
      as_mask([](const paint::EvalPoint& point) { return point.position.x > 0 ? 1 : 0; });
  const image::Image seen = render(over_a_light(black(right), 1), options(32, 32, 16, 0));
  const auto green = static_cast<size_t>(seen.find_channel("G"));
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 32; ++x) {
      // With z up in the picture and y towards the viewer, x runs to the left.
      const float expected = x < 16 ? 0 : 1;
      EXPECT_EQ(seen.at(x, y, green), expected) << x << ", " << y;
    }
}

TEST(Opacity, OfAnInstanceUsesItsOwnSpace) {
  const auto right =
      as_mask([](const paint::EvalPoint& point) { return point.position.x > 0 ? 1 : 0; });
  Scene scene = over_a_light(black(right), 1);
  scene.objects[1].instance = std::make_shared<const InstanceTransform>(
      Transform::rotation({0, 1, 0}, kPi / 2) * Transform::scaling(Vec3d(0.9)));
  const Mean seen = mean_of(render(scene, options(32, 32, 16, 0)), "G");
  EXPECT_NEAR(seen.value, 0.5, 0.01);
  scene.objects[1].instance =
      std::make_shared<const InstanceTransform>(Transform::translation({0.7, 0, 0}));
  EXPECT_EQ(mean_of(render(scene, options(32, 32, 16, 0)), "G").value, 1);
}

TEST(Opacity, ZeroIsInvisible) {
  Scene scene = over_a_light(black(as_mask([](const paint::EvalPoint&) { return 0; })), 2);
  scene.lights = {make_light("sky")};
  const Options o = options(16, 16, 16, 3);
  const image::Image with = render(scene, o);
  scene.objects.resize(1);
  const image::Image without = render(scene, o);
  for (const char* channel : {"R", "Z"}) {
    const auto a = static_cast<size_t>(with.find_channel(channel));
    const auto b = static_cast<size_t>(without.find_channel(channel));
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) ASSERT_EQ(with.at(x, y, a), without.at(x, y, b));
  }
}

TEST(Opacity, HalfTransparentWhiteVanishesInAWhiteSky) {
  Scene scene;
  scene.camera = view({0.2, 1, 0.5}, {0, 0, 0}, 0.5);
  scene.lights = {make_light("sky")};
  Object sheet = object(floor_mesh(1), 1);
  sheet.material = make_material("surface", {{"thin", true},
                                             {"subsurface", 1.0},
                                             {"through", 0.4},
                                             {"color", Vec3d(1)},
                                             {"opacity", 0.5}});
  scene.objects = {sheet, sheet};
  scene.objects[1].mesh = std::make_shared<mesh::Mesh>(at_height(floor_mesh(1), -0.3f));
  Options o = options(24, 24, 64, 200);
  o.openings = false;
  const Mean mean = mean_of(render(scene, o), "G");
  EXPECT_NEAR(mean.value, 1, 4 * mean.error + 0.002);
  EXPECT_LT(mean.error, 3e-3);
}

TEST(Opacity, IsTheSameForAnyNumberOfThreads) {
  const Scene scene = over_a_light(black(0.37), 3);
  const auto picture = [&](int threads) {
    return with_threads(threads, [&] { return render(scene, options(40, 40, 8, 2)); });
  };
  const image::Image one = picture(1);
  EXPECT_EQ(picture(2), one);
  EXPECT_EQ(picture(7), one);
}

TEST(Opacity, EmissiveObjectsHaveNoHoles) {
  Scene scene = over_a_light(black(0.3), 1);
  scene.objects[1].emission = Rgb(1);
  EXPECT_THROW(render(scene, options(4, 4, 1, 0)), Error);
  const MaterialPtr whole = black(1.0);
  EXPECT_FALSE(whole->cut_out());
  const auto value = [](const MaterialPtr& m) { return ValueTraits<MaterialPtr>::write(m); };
  const MaterialPtr mixed =
      make_material("mix", {{"a", value(black(0.2))}, {"b", value(whole)}, {"mask", 0.5}});
  EXPECT_TRUE(mixed->cut_out());
  EXPECT_NEAR(mixed->opacity(Surface()), 0.6, 1e-6);
}

}  // namespace
}  // namespace vug::render
