// SPDX-License-Identifier: Apache-2.0
// Relations between AOVs.
#include <vug/base/error.h>
#include <vug/render/film/aovs.h>
#include <vug/render/film/light_path_recorder.h>
#include <vug/render/film/surface_aov.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "scenes.h"

namespace vug::render {
namespace {

/// A lit corner with a wet floor, a visible light and haze: every component receives light.
Scene corner() {
  Scene scene;
  scene.camera = view({0, 1.5, 4}, {0, 0.5, 0}, 1.1);
  Object floor = object(floor_mesh(4), 0.5);
  floor.material = make_material("coated", {{"albedo", Vec3d(0.6, 0.4, 0.3)}, {"roughness", 0.2}});
  mesh::Mesh wall = floor_mesh(4);
  for (Vec3f& p : wall.positions) p = {p.x, p.z, -2.0f};
  scene.objects = {floor, object(wall, 0.7)};
  scene.lights = {make_light("sphere", {{"center", Vec3d(0.8, 1.4, 0)}, {"radius", 0.2}}),
                  make_light("sky", {{"radiance", Vec3d(0.1, 0.2, 0.3)}})};
  scene.medium = make_medium("haze", {{"extinction", 0.1}});
  return scene;
}

double channel_sum(const image::Image& picture, const std::string& channel) {
  return mean_of(picture, channel).value;
}

TEST(Aovs, SurfaceAovsAreListedOnceAndHaveUpToThreeChannels) {
  for (const SurfaceAov& aov : surface_aovs()) {
    EXPECT_EQ(std::count_if(aovs().begin(), aovs().end(),
                            [&](const AovInfo& info) { return info.name == aov.name; }),
              1)
        << aov.name;
    EXPECT_FALSE(aov.doc.empty()) << aov.name;
    EXPECT_GE(aov.channels.size(), 1u) << aov.name;
    EXPECT_LE(aov.channels.size(), 3u) << aov.name;
  }
}

TEST(Aovs, EachNameAndChannelIsInTheTableOnce) {
  std::set<std::string> names, channels;
  for (const AovInfo& row : aovs()) {
    EXPECT_TRUE(names.insert(row.name).second) << row.name;
    EXPECT_FALSE(row.doc.empty()) << row.name;
    EXPECT_FALSE(row.channels.empty()) << row.name;
    for (const std::string& channel : row.channels)
      EXPECT_TRUE(channels.insert(channel).second) << channel;
    EXPECT_EQ(row.write != nullptr, row.source == AovSource::pixel_sum) << row.name;
    EXPECT_EQ(find_aov(row.name), &row);
  }
  EXPECT_EQ(find_aov("light_key")->name, "light_NAME");
  EXPECT_EQ(name_in_aov("attribute_a_b"), "a_b");
  EXPECT_EQ(aov_channels("light_key"),
            (std::vector<std::string>{"light_key.R", "light_key.G", "light_key.B"}));
  EXPECT_EQ(find_aov("lights"), nullptr);
}

TEST(Aovs, PlansHaveTheOrderOfTheTable) {
  const AovPlan plan = plan_aovs({"all"}, {"sky", "key"}, {{"flow", 2}}, {"door", "wall"});
  std::vector<std::string> expected;
  for (const AovInfo& row : aovs())
    if (row.source == AovSource::light_group)
      expected.insert(expected.end(), {"light_sky", "light_key"});
    else
      expected.push_back(row.source == AovSource::attribute ? "attribute_flow" : row.name);
  EXPECT_EQ(plan.names, expected);
  EXPECT_EQ(plan.groups, (std::vector<std::string>{"sky", "key"}));
  EXPECT_EQ(plan.attributes, (std::vector<AovAttribute>{{"flow", 2}, {"door", 1}, {"wall", 1}}));
  EXPECT_TRUE(plan.is_consistent());
  AovPlan broken = plan;
  broken.groups.pop_back();
  EXPECT_FALSE(broken.is_consistent());
  broken = plan, broken.names.emplace_back("nonsense");
  EXPECT_FALSE(broken.is_consistent());
  broken = plan, broken.attributes.clear();
  EXPECT_FALSE(broken.is_consistent());
  broken = plan, broken.attributes[0].arity = 4;
  EXPECT_FALSE(broken.is_consistent());
}

TEST(Aovs, ComponentsSumToTheBeauty) {
  for (const bool clamp : {false, true}) {
    Options o = options(40, 30, 16, 4);
    if (clamp) o.integrator = make_integrator("path", {{"max_bounces", 4.0}, {"clamp", 0.02}});
    o.aovs = plan_aovs({"beauty", "parts"}, {});
    const image::Image picture = render(corner(), o);
    for (const char* c : {"R", "G", "B"})
      for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
          double sum = 0;
          for (const auto& [part, doc] : light_components())
            sum += static_cast<double>(
                picture.at(x, y, static_cast<size_t>(picture.find_channel(part + "." + c))));
          const auto beauty =
              static_cast<double>(picture.at(x, y, static_cast<size_t>(picture.find_channel(c))));
          ASSERT_NEAR(sum, beauty, 1e-5 * beauty + 1e-9) << x << " " << y << " " << c;
        }
    for (const char* part : {"emission", "diffuse_direct", "diffuse_indirect", "specular_direct",
                             "specular_indirect", "volume_direct", "volume_indirect"})
      EXPECT_GT(channel_sum(picture, std::string(part) + ".G"), 0) << part;
    EXPECT_EQ(channel_sum(picture, "transmission_direct.G"), 0);
  }
}

// Direct light equals the result of a path without bounces; all of it is sampled here, none found
// by chance in a bounce.
TEST(Aovs, DirectLightIsThatOfAPathWithoutBounces) {
  Scene scene = corner();
  scene.medium = nullptr;
  Options o = options(40, 30, 64, 4);
  o.aovs = plan_aovs({"beauty", "parts"}, {});
  o.integrator = make_integrator("path", {{"max_bounces", 4.0}, {"roulette", Value::Name{"off"}}});
  const image::Image longer = render(scene, o);
  o.integrator = make_integrator("path", {{"max_bounces", 0.0}});
  const image::Image direct = render(scene, o);
  for (const char* part : {"emission", "diffuse_direct", "specular_direct"})
    EXPECT_NEAR(channel_sum(longer, std::string(part) + ".R"),
                channel_sum(direct, std::string(part) + ".R"), 1e-6)
        << part;
  EXPECT_EQ(channel_sum(direct, "diffuse_indirect.R"), 0);
}

// The AOV of a light group equals the picture with only the lights of this group.
TEST(Aovs, GroupsArePicturesWithOnlyTheirLights) {
  const auto scene_with = [](bool light, bool sky) {
    Scene scene = corner();
    scene.lights.clear();
    if (light)
      scene.lights.push_back(make_light(
          "sphere", {{"center", Vec3d(0.8, 1.4, 0)}, {"radius", 0.2}, {"group", "key"}}));
    if (sky)
      scene.lights.push_back(
          make_light("sky", {{"radiance", Vec3d(0.1, 0.2, 0.3)}, {"group", "fill"}}));
    return scene;
  };
  Options o = options(40, 30, 256, 2);
  o.aovs = scene_aovs(scene_with(true, true), {"beauty", "lights", "parts"});
  EXPECT_EQ(o.aovs.groups, (std::vector<std::string>{"key", "fill"}));
  const image::Image both = render(scene_with(true, true), o);
  const image::Image key = render(scene_with(true, false), options(40, 30, 256, 2));
  const image::Image fill = render(scene_with(false, true), options(40, 30, 256, 2));
  for (const std::string c : {"R", "B"}) {
    EXPECT_NEAR(channel_sum(both, "light_key." + c), channel_sum(key, c),
                0.01 * channel_sum(key, c));
    EXPECT_NEAR(channel_sum(both, "light_fill." + c), channel_sum(fill, c),
                0.01 * channel_sum(fill, c));
    EXPECT_NEAR(channel_sum(both, "light_key." + c) + channel_sum(both, "light_fill." + c),
                channel_sum(both, c), 1e-5 * channel_sum(both, c));
  }
}

// Attributes are interpolated like positions, so an attribute that is linear in the position is the
// same function of the AOV P.
TEST(Aovs, AttributesMatchTheMeshAtP) {
  Scene scene = corner();
  mesh::Mesh floor = *scene.objects[0].mesh, wall = *scene.objects[1].mesh;
  mesh::Attribute age{"age", 1, {}}, flow{"flow", 3, {}};
  for (const Vec3f& p : floor.positions) {
    age.values.push_back(3 * p.x - 2 * p.z + 1);
    flow.values.insert(flow.values.end(), {p.x, -p.z, 0.25f});
  }
  floor.attributes = {age, flow};
  scene.objects[0].mesh = std::make_shared<mesh::Mesh>(floor);
  scene.objects[1].material =
      make_material("mix", {{"a", ValueTraits<MaterialPtr>::write(make_material("lambert"))},
                            {"b", ValueTraits<MaterialPtr>::write(make_material("coated"))},
                            {"mask", 0.25}});
  Options o = options(40, 30, 4, 1);
  o.aovs = scene_aovs(scene, {"beauty", "A", "P", "N", "wetness", "attributes"});
  const image::Image picture = render(scene, o);
  EXPECT_EQ(o.aovs.channels(),
            (std::vector<std::string>{"R", "G", "B", "A", "N.X", "N.Y", "N.Z", "P.X", "P.Y", "P.Z",
                                      "wetness", "attribute_age.X", "attribute_flow.X",
                                      "attribute_flow.Y", "attribute_flow.Z"}));
  const auto value = [&](int x, int y, const char* channel) {
    return static_cast<double>(
        picture.at(x, y, static_cast<size_t>(picture.find_channel(channel))));
  };
  int on_floor = 0, on_wall = 0;
  for (int y = 0; y < picture.height; ++y)
    for (int x = 0; x < picture.width; ++x) {
      if (value(x, y, "N.Y") > 0.9999 && value(x, y, "P.Y") < 1e-5) {
        const double px = value(x, y, "P.X"), pz = value(x, y, "P.Z");
        ASSERT_NEAR(value(x, y, "attribute_age.X"), 3 * px - 2 * pz + 1, 1e-4);
        ASSERT_NEAR(value(x, y, "attribute_flow.X"), px, 1e-5);
        ASSERT_NEAR(value(x, y, "attribute_flow.Y"), -pz, 1e-5);
        ASSERT_NEAR(value(x, y, "attribute_flow.Z"), 0.25, 1e-6);
        ASSERT_NEAR(value(x, y, "wetness"), 1, 1e-6);
        ++on_floor;
      } else if (value(x, y, "N.Z") > 0.9999) {
        ASSERT_EQ(value(x, y, "attribute_age.X"), 0);  // this mesh has no such attribute
        ASSERT_NEAR(value(x, y, "wetness"), 0.25, 1e-6);
        ++on_wall;
      }
    }
  EXPECT_GT(on_floor, 200);
  EXPECT_GT(on_wall, 100);
  EXPECT_THROW(scene_aovs(scene, {"beauty", "attribute_agee"}), Error);
}

// Light through water and glass is in the transmission component, and the components sum to the
// beauty.
TEST(Aovs, ComponentsOfTransparentBodiesSumToTheBeauty) {
  Scene scene = corner();
  Object ball = object(mesh::sphere_mesh({0, 0.7, 0.5}, 0.7, 3), 0.5);
  ball.material = make_material("surface", {{"transmission", 0.8}, {"roughness", 0.1}});
  scene.objects.push_back(ball);
  Options o = options(24, 18, 16, 6);
  o.aovs = plan_aovs({"beauty", "parts"}, {});
  const image::Image picture = render(scene, o);
  double through = 0;
  for (size_t p = 0; p < picture.pixel_count(); ++p) {
    const float* values = &picture.pixels[p * picture.channels.size()];
    double sum = 0;
    for (const auto& [part, doc] : light_components())
      sum += static_cast<double>(values[picture.find_channel(part + ".G")]);
    const auto beauty = static_cast<double>(values[picture.find_channel("G")]);
    ASSERT_NEAR(sum, beauty, 1e-5 * beauty + 1e-9);
    through += static_cast<double>(values[picture.find_channel("transmission_indirect.G")] +
                                   values[picture.find_channel("transmission_direct.G")]);
  }
  EXPECT_GT(through, 0);
}

TEST(Aovs, RequestedAovsDoNotChangeOthers) {
  Options o = options(20, 15, 4, 2);
  const image::Image usual = render(corner(), o);
  o.aovs = plan_aovs({"all"}, {});
  EXPECT_EQ(render(corner(), o).select(usual.channels), usual);
}

TEST(Aovs, NamesAreChecked) {
  EXPECT_EQ(plan_aovs({"samples", "beauty"}, {}).channels(),
            (std::vector<std::string>{"R", "G", "B", "samples"}));
  EXPECT_TRUE(plan_aovs({"beauty", "lights"}, {"key", "sky"}).has("light_sky"));
  try {
    plan_aovs({"beauty", "difuse_direct"}, {});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(error.hint().find("diffuse_direct"), std::string::npos) << error.hint();
  }
  EXPECT_THROW(plan_aovs({"Z"}, {}), Error);
}

}  // namespace
}  // namespace vug::render
