// SPDX-License-Identifier: Apache-2.0
// Kinds of lights against closed forms, their colours and powers, and light linking.
#include "scenes.h"
#include "uniform.h"

#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/render/lighting/light_output.h>
#include <vug/render/lighting/light_set.h>
#include <vug/render/sampling.h>

#include <gtest/gtest.h>

#include <algorithm>

namespace vug::render {
namespace {

/// The required parameters of a kind of light.
NamedValues needed(const KindInfo& info) {
  return info.name == "ies" ? NamedValues{{"file", VUG_TEST_DATA "/lights/cosine.ies"}}
                            : NamedValues{};
}

bool has(const KindInfo& info, const std::string& parameter) {
  return std::any_of(info.params.begin(), info.params.end(),
                     [&](const ParamInfo& p) { return p.name == parameter; });
}

/// Compares the radiance of a white floor at the origin.
void expect_floor(const std::vector<LightPtr>& lights, double expected, int spp = 256,
                  double allowed = 2e-4) {
  Scene scene;
  scene.camera = view({0.4, 0.3, 0}, {0, 0, 0}, 1e-3);
  scene.objects = {object(floor_mesh(2), 1)};
  scene.lights = lights;
  const Mean mean = mean_of(render(scene, options(32, 32, spp, 0)), "G");
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + allowed * expected);
  EXPECT_LT(mean.error, 5e-3 * expected);
}

TEST(Lights, DiskOverAFloor) {
  for (const double height : {0.3, 1.0, 20.0}) {
    SCOPED_TRACE(height);
    const LightPtr disk =
        make_light("disk", {{"center", Vec3d(0, height, 0)}, {"radius", 0.5}, {"visible", false}});
    expect_floor({disk}, 0.25 / (0.25 + height * height), 1024);
  }
}

TEST(Lights, SpotOnItsAxisAndOnItsEdge) {
  const double radius = 0.02, wide = 0.5, edge = 0.4;
  const auto spot = [&](const Vec3d& direction) {
    return make_light("spot", {{"center", Vec3d(0, 2, 0)},
                               {"direction", direction},
                               {"angle", radians(2 * wide)},
                               {"edge", edge},
                               {"radius", radius},
                               {"radiance", Vec3d(900)},
                               {"visible", false}});
  };
  const double full = 900 * radius * radius / 4;
  expect_floor({spot({0, -1, 0})}, full);
  // Half of the light where the cosine is midway between those of the edge.
  const double middle = std::acos(0.5 * (std::cos(wide) + std::cos(wide * (1 - edge))));
  // The sphere subtends an angle of 0.02, over which the smooth edge bends: second order, about
  // 1e-3.
  expect_floor({spot({std::sin(middle), -std::cos(middle), 0})}, full / 2, 1024, 2e-3);
  const double outside = wide + 0.02;
  const LightPtr away = spot({std::sin(outside), -std::cos(outside), 0});
  EXPECT_EQ(away->importance({{0, 0, 0}, {0, 1, 0}}), 0);
}

/// The whole cone is within some thousand steps of a cosine's last digits.
TEST(Lights, NarrowSpotsHaveAnEdge) {
  const double half = 0.015 * kPi / 180, edge = 0.4;
  const auto seen = [&](double off) {
    const LightPtr spot =
        make_light("spot", {{"center", Vec3d(0, 2, 0)},
                            {"direction", Vec3d(std::sin(off), -std::cos(off), 0)},
                            {"angle", radians(2 * half)},
                            {"edge", edge},
                            {"radius", 1e-6}});
    return spot->sample({{0, 0, 0}, {0, 1, 0}}, {0.5f, 0.5f}).radiance.x;
  };
  const double middle =
      2 * std::asin(std::sqrt(0.5 * (std::pow(std::sin(half / 2), 2) +
                                     std::pow(std::sin(half * (1 - edge) / 2), 2))));
  EXPECT_GT(seen(0), 0);
  EXPECT_EQ(seen(0.99 * half * (1 - edge)), seen(0));
  EXPECT_NEAR(seen(middle) / seen(0), 0.5, 0.02);
  EXPECT_LT(seen(0.99 * half), 0.01f * seen(0));
  EXPECT_EQ(seen(1.01 * half), 0);
}

TEST(Lights, MeasuredLightsHaveTheirCandela) {
  // 1000 cd straight down at 2 m: 250 lx; a white floor reflects E / pi.
  const LightPtr light = make_light("ies", {{"file", VUG_TEST_DATA "/lights/cosine.ies"},
                                            {"center", Vec3d(0, 2, 0)},
                                            {"radius", 0.01},
                                            {"visible", false}});
  expect_floor({light}, 250 / kLumenPerWatt / kPi);
}

TEST(Lights, SunIrradianceFollowsTheSineOfItsHeight) {
  for (const double angle : {0.00931, 0.4}) {
    const LightPtr sun = make_light("sun", {{"elevation", radians(0.7)},
                                            {"azimuth", radians(2)},
                                            {"angle", radians(angle)},
                                            {"irradiance", Vec3d(5)}});
    expect_floor({sun}, 5 / kPi * std::sin(0.7));
  }
}

TEST(Lights, PortalsKeepTheSun) {
  // A portal samples the sky in its own directions; the sun is sampled separately, inside or
  // outside of it.
  const LightPtr sky = make_light("sky", {{"radiance", Vec3d(2)}});
  const LightPtr portal =
      make_light("portal", {{"center", Vec3d(0, 1, 0)}, {"width", 1.5}, {"height", 1.5}});
  for (const double elevation : {1.4, 0.4}) {
    SCOPED_TRACE(elevation);
    const LightPtr sun =
        make_light("sun", {{"elevation", radians(elevation)}, {"irradiance", Vec3d(8)}});
    const double expected = 2 + 8 / kPi * std::sin(elevation);
    expect_floor({sky, sun}, expected, 1024);
    expect_floor({sky, sun, portal}, expected, 1024);
  }
}

TEST(Lights, SunPositionFollowsTheClock) {
  const auto towards = [](double latitude, double day, double hour) {
    const LightPtr sun =
        make_light("sun", {{"latitude", radians(latitude)}, {"day", day}, {"hour", hour}});
    return sun->sample({}, {0, 0}).direction;
  };
  // At the equinox the sun rises in the east, and its height at noon is the complement of the
  // latitude.
  const Vec3f noon = towards(0.8, 81, 12), morning = towards(0.8, 81, 6);
  EXPECT_NEAR(noon.y, std::cos(0.8), 0.01);
  EXPECT_NEAR(noon.z, std::sin(0.8), 0.01) << "south is z";
  EXPECT_NEAR(morning.x, 1, 0.01);
  EXPECT_NEAR(towards(0.8, 172, 12).y, std::sin(kPi / 2 - 0.8 + 23.44 * kPi / 180), 0.01);
}

TEST(Lights, SunPositionIsGivenInOneWay) {
  EXPECT_NO_THROW(make_light("sun", {{"azimuth", radians(1)}}));
  EXPECT_NO_THROW(make_light("daylight", {{"latitude", radians(1)}}));
  for (const char* kind : {"sun", "daylight"})
    for (const NamedValues& both :
         {NamedValues{{"latitude", radians(1)}, {"elevation", radians(1)}},
          NamedValues{{"latitude", radians(1)}, {"azimuth", radians(1)}},
          NamedValues{{"day", 100.0}}, NamedValues{{"hour", 12.0}}})
      EXPECT_THROW(make_light(kind, both), Error) << kind << " " << both.back().first;
}

TEST(Lights, SunReddensAsItSets) {
  const auto colour = [](double elevation) {
    return make_light("sun", {{"elevation", radians(elevation)}})
        ->eval_environment(
            make_light("sun", {{"elevation", radians(elevation)}})->sample({}, {0, 0}).direction);
  };
  const Rgb high = colour(1.2), low = colour(0.1);
  EXPECT_LT(low.z / low.x, 0.5f * high.z / high.x);
  EXPECT_LT(luminance(low), 0.5f * luminance(high));
  // About 100 klx from a high sun through clear air (Preetham and others 1999).
  const double part = std::pow(std::sin(0.533 * kPi / 360), 2) * kPi;
  EXPECT_NEAR(luminance(high) * part * kLumenPerWatt, 95000, 12000);
}

TEST(Lights, DaylightHasTheLuminanceOfItsModel) {
  const LightPtr sky =
      make_light("daylight", {{"elevation", radians(kPi / 4)}, {"turbidity", 3.0}});
  const double chi = (4.0 / 9 - 3.0 / 120) * (kPi / 2);
  const double zenith = (4.0453 * 3 - 4.9710) * std::tan(chi) - 0.2155 * 3 + 2.4192;  // kcd/m^2
  const double seen = luminance(sky->eval_environment({0, 1, 0})) * kLumenPerWatt / 1000;
  EXPECT_NEAR(seen, zenith, 0.01 * zenith);
  const Rgb blue = sky->eval_environment({0, 1, 0});
  EXPECT_GT(blue.z, 1.5f * blue.x);
  // The irradiance of the floor is that of a quadrature over the sky.
  double sum = 0;
  constexpr int kRows = 400;
  for (int i = 0; i < kRows; ++i)
    for (int j = 0; j < 2 * kRows; ++j) {
      const double squared = (i + 0.5) / kRows;
      const Vec3f d = direction_at(static_cast<float>(std::sqrt(1 - squared)),
                                   static_cast<float>((j + 0.5) / (2 * kRows)));
      sum += static_cast<double>(sky->eval_environment({d.x, d.z, d.y}).y) / (2 * kRows * kRows);
    }
  expect_floor({sky}, sum, 1024);
}

/// For any shape and profile, the flux through a sphere around the light is the requested one.
TEST(Lights, EveryLightEmitsItsLumen) {
  for (const auto* kind : lights()) {
    if (!has(kind->info, "lumen")) continue;
    SCOPED_TRACE(kind->info.name);
    NamedValues given = needed(kind->info);
    given.emplace_back("lumen", 10 * kLumenPerWatt);
    given.emplace_back("radiance", Vec3d(0.2, 1, 3));
    const LightPtr light = make_light(kind->info.name, given);
    constexpr float kAway = 60;
    constexpr int kSamples = 200000;
    RandomStream random{RandomKey(21)};
    double sum = 0;
    for (int i = 0; i < kSamples; ++i) {
      const float a = uniform(random);
      const Vec3f out = sample_sphere({a, uniform(random)});
      const float u = uniform(random);
      const LightSample s =
          light->sample({light->center() + out * kAway, -out}, {u, uniform(random)});
      if (s.pdf > 0)
        sum += static_cast<double>(luminance(s.radiance) * -dot(s.direction, out) / s.pdf);
    }
    const double watts = 4 * kPi * kAway * kAway * sum / kSamples;
    EXPECT_NEAR(watts, 10, 0.15);
  }
}

TEST(Lights, BranchBoundsContainTheirLights) {
  for (const auto* kind : lights()) {
    if (!has(kind->info, "lumen")) continue;
    SCOPED_TRACE(kind->info.name);
    // The second light makes a branch, whose bounds are used.
    const LightPtr light = make_light(kind->info.name, needed(kind->info));
    const LightTree tree(1, 0, [&](size_t) { return light->bounds(); });
    RandomStream random{RandomKey(22)};
    int contributions = 0;
    for (int i = 0; i < 20000; ++i) {
      const float a = uniform(random), far = 0.05f + 4 * uniform(random) * uniform(random);
      LightSampleContext point{light->center() + sample_sphere({a, uniform(random)}) * far};
      const float b = uniform(random);
      if (i % 2) point.normal = sample_sphere({b, uniform(random)});
      const float u = uniform(random);
      const LightSample s = light->sample(point, {u, uniform(random)});
      if (!(s.pdf > 0) || is_black(s.radiance)) continue;
      if (point.on_surface() && !(dot(point.normal, s.direction) > 1e-3f)) continue;
      ++contributions;
      EXPECT_GT(light->importance(point), 0);
      EXPECT_GT(LightTree::importance(tree.node(0), point)[0], 0);
    }
    EXPECT_GT(contributions, 100);
  }
}

/// Chromaticities (x, y) of a colour in linear Rec.709.
std::pair<double, double> chromaticity(const Vec3d& c) {
  const double x = 0.4124564 * c.x + 0.3575761 * c.y + 0.1804375 * c.z;
  const double y = 0.2126729 * c.x + 0.7151522 * c.y + 0.0721750 * c.z;
  const double z = 0.0193339 * c.x + 0.1191920 * c.y + 0.9503041 * c.z;
  return {x / (x + y + z), y / (x + y + z)};
}

TEST(LightOutput, BlackBodiesHaveTheirColours) {
  // CIE 15: illuminant A is a black body of 2856 K; the others are from its tables of the locus.
  const double table[][3] = {{2856, 0.4476, 0.4074},
                             {4000, 0.3805, 0.3768},
                             {6500, 0.3135, 0.3237},
                             {10000, 0.2807, 0.2884}};
  for (const auto& row : table) {
    SCOPED_TRACE(row[0]);
    const auto [x, y] = chromaticity(blackbody(row[0]));
    EXPECT_NEAR(x, row[1], 0.006);
    EXPECT_NEAR(y, row[2], 0.006);
    EXPECT_NEAR(luminance(Rgb(blackbody(row[0]))), 1, 1e-4);
  }
  for (const double kelvin : {800.0, 40000.0})
    EXPECT_GE(std::min({blackbody(kelvin).x, blackbody(kelvin).y, blackbody(kelvin).z}), 0);
}

std::string refusal_of_light(const std::string& kind, const NamedValues& parameters) {
  try {
    make_light(kind, parameters);
  } catch (const Error& error) {
    return error.what();
  }
  return "accepted";
}

TEST(LightOutput, ContradictionsAreRejected) {
  EXPECT_NE(refusal_of_light("disk", {{"power", 1.0}, {"lumen", 1.0}}).find("not in both"),
            std::string::npos);
  EXPECT_NE(refusal_of_light("sphere", {{"power", 1.0}, {"radiance", Vec3d(0)}}).find("above 0"),
            std::string::npos);
  for (const double size : {0.0, 1e300})
    EXPECT_NE(refusal_of_light("spot", {{"direction", Vec3d(size)}}).find("direction"),
              std::string::npos);
  EXPECT_NE(refusal_of_light("disk", {{"radius", 0.0}}).find("radius"), std::string::npos);
  EXPECT_NE(refusal_of_light("rect", {{"temperature", 5.0}}).find("temperature"),
            std::string::npos);
}

/// Two adjacent floors under one light and a sky.
Scene two_floors(const std::vector<LightPtr>& lights) {
  Scene scene;
  mesh::Mesh left = floor_mesh(1), right = floor_mesh(1);
  for (Vec3f& p : left.positions) p.x -= 1;
  for (Vec3f& p : right.positions) p.x += 1;
  scene.objects = {object(left, 0.5), object(right, 0.5)};
  scene.objects[0].name = "left";
  scene.objects[1].name = "right";
  scene.camera = view({0, 4, 0.01}, {0, 0, 0}, 0.4);
  scene.lights = lights;
  return scene;
}

TEST(LightLinking, LightsReachOnlyTheirObjects) {
  const auto light = [](const NamedValues& more) {
    NamedValues p{
        {"center", Vec3d(0, 1, 0)}, {"radius", 0.1}, {"radiance", Vec3d(20)}, {"visible", false}};
    p.insert(p.end(), more.begin(), more.end());
    return make_light("sphere", p);
  };
  const auto sides = [](const image::Image& picture) {
    double left = 0, right = 0;
    for (int y = 0; y < picture.height; ++y)
      for (int x = 0; x < picture.width; ++x)
        (2 * x < picture.width ? left : right) += static_cast<double>(picture.at(x, y, 1));
    return std::pair(left, right);
  };
  const Options o = options(32, 16, 16, 0);
  const auto [left, right] = sides(render(two_floors({light({})}), o));
  EXPECT_GT(left, 1);
  const auto [only_left, no_right] = sides(render(two_floors({light({{"only", "left"}})}), o));
  EXPECT_NEAR(only_left, left, 0.02 * left);
  EXPECT_EQ(no_right, 0);
  const auto [no_left, only_right] = sides(render(two_floors({light({{"except", "left"}})}), o));
  EXPECT_EQ(no_left, 0);
  EXPECT_NEAR(only_right, right, 0.02 * right);
  // Skies are linked too, and many lights in a tree.
  const auto [dark, lit] = sides(render(two_floors({make_light("sky", {{"only", "right"}})}), o));
  EXPECT_EQ(dark, 0);
  EXPECT_GT(lit, 1);
  std::vector<LightPtr> many;
  for (int i = 0; i < 40; ++i) many.push_back(light({{"only", List{Value("left")}}}));
  const auto [bright, none] = sides(render(two_floors(many), o));
  EXPECT_NEAR(bright, 40 * left, 0.1 * 40 * left);
  EXPECT_EQ(none, 0);
  try {
    render(two_floors({light({{"only", "lefd"}})}), o);
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("lefd"), std::string::npos);
    EXPECT_NE(error.hint().find("left"), std::string::npos);
  }
}

TEST(LightLinking, GroupsAreListedOnce) {
  Scene scene = two_floors({make_light("sphere", {{"group", "key"}}), make_light("sky"),
                            make_light("disk", {{"group", "fill"}}),
                            make_light("sphere", {{"group", "key"}})});
  scene.objects[1].emission = Rgb(1);
  scene.objects[1].light_group = "glow";
  const LightSet set(scene.lights, scene.objects);
  const auto name = [&](LightId id) {
    return set.group(id) == LightSet::kNoGroup ? "" : set.groups().at(set.group(id));
  };
  EXPECT_EQ(set.groups().size(), 3u);
  EXPECT_EQ(name(0), "key");
  EXPECT_EQ(name(1), "");
  EXPECT_EQ(name(2), "fill");
  EXPECT_EQ(name(3), "key");
  EXPECT_EQ(name(set.emitter(1, 1)), "glow");
}

}  // namespace
}  // namespace vug::render
