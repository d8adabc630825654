// SPDX-License-Identifier: Apache-2.0
// Cameras, lights and materials as data for the files of other programs.
#include <vug/base/error.h>
#include <vug/exchange/camera.h>
#include <vug/exchange/light.h>
#include <vug/exchange/look.h>
#include <vug/render/kinds.h>
#include <vug/render/lighting/transformed_light.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::render {
namespace {

exchange::Light exported(const LightPtr& light) {
  exchange::Light lamp;
  EXPECT_TRUE(light->as_data(lamp));
  return lamp;
}

const char* const kLights[] = {"sphere", "rect", "disk", "spot"};

TEST(AsData, LampsHaveTheWattsThatWereAskedFor) {
  for (const char* kind : kLights) {
    const exchange::Light lamp =
        exported(make_light(kind, {{"power", 100.0}, {"radiance", Vec3d(3, 2, 1)}}));
    EXPECT_NEAR(exchange::luminance(exchange::power(lamp)), 100, 1e-3) << kind;
    EXPECT_NEAR(lamp.radiance.x / lamp.radiance.z, 3, 1e-6) << kind;
  }
}

TEST(AsData, LampsShineTheWayTheyDo) {
  const Vec3d way = Vec3d(1, -2, 0.5).normalized();
  for (const char* kind : {"rect", "disk", "spot"}) {
    const std::string name = std::string(kind) == "spot" ? "direction" : "normal";
    const LightPtr light = make_light(kind, {{name, way}, {"center", Vec3d(1, 2, 3)}});
    const exchange::Light lamp = exported(light);
    EXPECT_LT((lamp.place.vector({0, 0, -1}) - way).length(), 1e-6) << kind;
    EXPECT_LT((lamp.place.origin() - Vec3d(1, 2, 3)).length(), 1e-6) << kind;
    EXPECT_NEAR(lamp.place.determinant(), 1, 1e-6) << kind;
    // A ray that comes towards it meets the exported radiance.
    LightHit hit;
    const Vec3d from = lamp.place.point({0, 0, -5});
    ASSERT_TRUE(light->intersect({Vec3f(from), Vec3f(-way)}, 100, hit)) << kind;
    EXPECT_LT((Vec3d(hit.radiance) - lamp.radiance).length(), 1e-6) << kind;
  }
}

TEST(AsData, ARectanglesSidesLieWhereTheyLie) {
  const LightPtr light = make_light(
      "rect",
      {{"normal", Vec3d(0, 0, 1)}, {"up", Vec3d(1, 0, 0)}, {"width", 0.5}, {"height", 2.0}});
  const exchange::Light lamp = exported(light);
  for (const double x : {-0.9, 0.9, -1.1, 1.1})
    for (const double y : {-0.2, 0.2, -0.3, 0.3}) {
      LightHit hit;
      const Vec3f at(static_cast<float>(x), static_cast<float>(y), 1);
      const Vec3d own = lamp.place.inverse().point({x, y, 0});
      const bool inside = std::fabs(own.x) < lamp.width / 2 && std::fabs(own.y) < lamp.height / 2;
      EXPECT_EQ(light->intersect({at, {0, 0, -1}}, 10, hit), inside) << x << " " << y;
    }
}

TEST(AsData, TheSunsStrengthIsItsIrradiance) {
  const exchange::Light sun = exported(make_light("sun", {{"irradiance", Vec3d(10, 9, 8)},
                                                          {"angle", radians(0.01)},
                                                          {"elevation", radians(kPi / 2)}}));
  EXPECT_LT((exchange::peak_intensity(sun) - Vec3d(10, 9, 8)).length(), 1e-4);
  EXPECT_NEAR(sun.angle, 0.01, 1e-8);
  EXPECT_LT((sun.place.vector({0, 0, -1}) - Vec3d(0, -1, 0)).length(), 1e-6);
}

TEST(AsData, ADomesPictureIsTheSky) {
  const LightPtr sky = make_light("daylight", {{"elevation", radians(0.5)}});
  const exchange::Light dome = exported(sky);
  ASSERT_TRUE(dome.picture);
  const image::Image& picture = *dome.picture;
  const int columns[] = {5, picture.width / 2, picture.width - 9};
  for (const int x : columns)
    for (const int y : {3, picture.height / 4, picture.height - 5}) {
      const double across = 2 * kPi * ((x + 0.5) / picture.width - 0.5);
      const double down = kPi * (y + 0.5) / picture.height;
      const Vec3d own(std::sin(down) * std::sin(across), std::cos(down),
                      -std::sin(down) * std::cos(across));
      const Rgb there = sky->eval_environment(Vec3f(dome.place.vector(own)));
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(there[static_cast<int>(c)], picture.at(x, y, c),
                    1e-3f + 1e-3f * picture.at(x, y, c));
    }
}

TEST(AsData, PlacedLampsGrow) {
  const Transform place = Transform::translation({1, 2, 3}) *
                          Transform::rotation({0, 1, 0}, 0.5 * kPi) *
                          Transform::scaling(Vec3d(3.0));
  for (const char* kind : kLights) {
    const LightPtr lamp = make_light(kind);
    const exchange::Light before = exported(lamp),
                          after = exported(transformed_light(lamp, place, {}));
    EXPECT_NEAR(exchange::power(after).x / exchange::power(before).x, 9, 1e-5) << kind;
    EXPECT_LT((after.place.origin() - place.point(before.place.origin())).length(), 1e-6);
  }
}

TEST(AsData, PortalsAreNoLights) {
  exchange::Light lamp;
  EXPECT_FALSE(make_light("portal")->as_data(lamp));
}

TEST(AsData, CamerasSeeWhatTheySee) {
  const NamedValues view = {
      {"eye", Vec3d(1, 2, 3)}, {"target", Vec3d(-2, 1, 0)}, {"up", Vec3d(0.1, 1, 0)}};
  constexpr float kAspect = 1.5f;
  for (const char* kind : {"perspective", "orthographic"}) {
    const CameraPtr camera = make_camera(kind, view);
    exchange::Camera data;
    ASSERT_TRUE(camera->as_data(data));
    for (const float x : {0.0f, 0.3f, 1.0f})
      for (const float y : {0.0f, 0.8f, 1.0f}) {
        const Ray ray = camera->ray({x, y}, kAspect, {0.5f, 0.5f});
        const auto right = static_cast<double>(2 * x - 1),
                   up = static_cast<double>((1 - 2 * y) / kAspect);
        const double wide = data.orthographic ? 0.5 * data.span : std::tan(0.5 * data.fov);
        const Vec3d at(right * wide, up * wide, 0);
        const Vec3d origin = data.place.point(data.orthographic ? at : Vec3d(0.0));
        const Vec3d way =
            data.place.vector(data.orthographic ? Vec3d(0, 0, -1) : Vec3d(at.x, at.y, -1));
        EXPECT_LT((Vec3d(ray.origin) - origin).length(), 1e-5) << kind;
        EXPECT_LT((Vec3d(ray.direction) - way.normalized()).length(), 1e-5) << kind;
      }
  }
  exchange::Camera none;
  EXPECT_FALSE(make_camera("panoramic", view)->as_data(none));
}

TEST(AsData, LooksOfMaterials) {
  Surface surface;
  surface.shading_normal = surface.geometric_normal = {0, 1, 0};
  surface.color = {0.5f, 1, 1};
  const exchange::Look grey =
      make_material("lambert", {{"albedo", Vec3d(0.8, 0.4, 0.2)}})->look(surface);
  EXPECT_LT((grey.base_color - Vec3d(0.4, 0.4, 0.2)).length(), 1e-6);
  EXPECT_EQ(grey.roughness, 1);
  const exchange::Look wet = make_material("surface", {{"color", Vec3d(0.8, 0.4, 0.2)},
                                                       {"roughness", 0.25},
                                                       {"coat", 0.5},
                                                       {"metal", 0.125},
                                                       {"fuzz", 0.5},
                                                       {"fuzz_color", Vec3d(0, 1, 0)}})
                                 ->look(surface);
  EXPECT_LT((wet.base_color - Vec3d(0.2, 0.7, 0.1)).length(), 1e-6);
  EXPECT_EQ(wet.roughness, 0.25);
  EXPECT_EQ(wet.wetness, 0.5);
  EXPECT_EQ(wet.metallic, 0.125);
  // Every kind says something that the formats can hold.
  for (const Kind<MaterialPtr>* kind : materials()) {
    if (kind->info.name == "mix" || kind->info.name == "by_rock") continue;
    const exchange::Look look = make_material(kind->info.name)->look(surface);
    for (const double share : {look.base_color.x, look.roughness, look.metallic, look.wetness})
      EXPECT_TRUE(share >= 0 && share <= 1) << kind->info.name;
  }
}

}  // namespace
}  // namespace vug::render
