// SPDX-License-Identifier: Apache-2.0
// Pictures of a part of a scene: the lights, objects and air that a render block selects.
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/building/builder.h>
#include <vug/loading/load.h>
#include <vug/loading/placement/check.h>
#include <vug/picture/picture.h>
#include <vug/shot/queries.h>
#include <vug/shot/selection.h>

namespace vug::picture {
namespace {

using Names = std::vector<std::string>;

constexpr const char* kSelections = R"(
volume ground = level_set(box(size: (8, 1, 8)), voxel: 25cm)
volume block = level_set(box(size: (1, 1, 1)).translate((0, 1, 0)), voxel: 10cm)
volume pebble = level_set(sphere(20cm), voxel: 5cm)
mesh ground_mesh on ground {}
mesh block_mesh on block {}
mesh pebble_mesh on pebble {}
object floor on ground_mesh {}
object statue on block_mesh {}
object stone on pebble_mesh {}
place stones { of stone  at [(2, 0.7, 0), (2, 0.7, 1)]  apart true }
light key = rect(center: (0, 4, 0), normal: (0, -1, 0), width: 1m, height: 1m, only: ["statue"])
light fill = sphere(center: (3, 3, 0), radius: 10cm, except: ["stones/1", "floor"])
medium mist = haze(extinction: 2%/m)
medium smoke = haze(extinction: 30%/m)
camera main { eye (0, 2, 6)  target (0, 1, 0) }
render whole { air mist }
render part { objects [floor, stones]  lights fill  air none }
render dark { lights []  objects statue  air smoke }
)";

loading::Loaded loaded_scene(const std::string& text = kSelections) {
  loading::Loaded loaded = loading::load_text(text, "t.vug");
  EXPECT_EQ(loaded.report(), "");
  return loaded;
}

PicturePlan plan_of(const shot::Shot& shot, const std::string& render,
                    const NamedValues& settings = {}) {
  PictureOptions options;
  options.render = render;
  options.settings = settings;
  return plan_picture(shot, options);
}

Names object_names(const render::Scene& scene) {
  Names names;
  for (const render::Object& object : scene.objects) names.push_back(object.name);
  return names;
}

class Selection : public testing::Test {
 protected:
  render::Scene scene_of(const std::string& render, const NamedValues& settings = {}) {
    return build_scene(builder_, plan_of(loaded_.shot, render, settings));
  }
  loading::Loaded loaded_ = loaded_scene();
  building::Builder builder_{loaded_.shot};
};

TEST_F(Selection, EverythingTakesPartByDefault) {
  const render::Scene scene = scene_of("whole");
  EXPECT_EQ(object_names(scene), (Names{"floor", "statue", "stones/1", "stones/2"}));
  EXPECT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.medium, loaded_.shot.media[0].medium);
  EXPECT_EQ(scene.omitted, Names{});
}

TEST_F(Selection, OnlySelectedObjectsLightsAndAirAreTraced) {
  const render::Scene scene = scene_of("part");
  EXPECT_EQ(object_names(scene), (Names{"floor", "stones/1", "stones/2"}));
  ASSERT_EQ(scene.lights.size(), 1u);
  EXPECT_EQ(scene.lights[0], loaded_.shot.lights[1].second);
  EXPECT_EQ(scene.medium, nullptr);
  EXPECT_EQ(scene.omitted, Names{"statue"});
}

TEST_F(Selection, NoLightsAddNoSky) {
  const render::Scene scene = scene_of("dark");
  EXPECT_EQ(object_names(scene), Names{"statue"});
  EXPECT_TRUE(scene.lights.empty());
  EXPECT_EQ(scene.medium, loaded_.shot.media[1].medium);
}

TEST_F(Selection, LinksToOmittedObjectsHaveNoEffect) {
  const NamedValues settings = {
      {"size", List{8, 8}}, {"spp", 1}, {"objects", List{"stones"}}, {"lights", List{"key"}}};
  const PictureJob job = prepare_picture(builder_, plan_of(loaded_.shot, "part", settings), false);
  const image::Image picture = render::render(job.scene, job.options);
  const int red = picture.find_channel("R");
  ASSERT_GE(red, 0);
  // 'key' lights only the statue, which is omitted.
  for (int y = 0; y < 8; ++y)
    for (int x = 0; x < 8; ++x) ASSERT_EQ(picture.at(x, y, static_cast<size_t>(red)), 0.f);
}

TEST_F(Selection, OnlyNeededMeshesAreBuilt) {
  building::Builder builder(loaded_.shot);
  build_scene(builder, plan_of(loaded_.shot, "part"));
  std::string built;
  for (const shot::MeshPtr& mesh : loaded_.shot.meshes)
    if (builder.has_mesh(mesh)) built += mesh->name + " ";
  EXPECT_EQ(built, "ground_mesh pebble_mesh ");
}

TEST_F(Selection, OptionsReplaceTheBlock) {
  const render::Scene scene =
      scene_of("part", {{"objects", List{"statue"}}, {"air", Value("smoke")}});
  EXPECT_EQ(object_names(scene), Names{"statue"});
  EXPECT_EQ(scene.medium, loaded_.shot.media[1].medium);
  try {
    scene_of("part", {{"objects", List{"statua"}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(std::string(error.what()), "--objects: the scene has no object or place 'statua'");
    EXPECT_EQ(error.hint(), "did you mean 'statue'?");
  }
}

TEST_F(Selection, MattesAndGroupsAreThoseOfThePart) {
  EXPECT_EQ(shot::selectable_objects(*plan_of(loaded_.shot, "part").shown),
            (Names{"floor", "stones"}));
  EXPECT_EQ(plan_of(loaded_.shot, "whole").shown->objects.size(), 3u);
}

TEST(SelectionOfMeshes, WorksWithoutObjects) {
  const loading::Loaded loaded = loaded_scene(
      "volume a = level_set(sphere(1m), voxel: 20cm)\n"
      "volume b = level_set(sphere(2m), voxel: 20cm)\nrender main { objects b }\n"
      "render none { objects [] }\nlight l = sphere()\n");
  building::Builder builder(loaded.shot);
  EXPECT_EQ(object_names(build_scene(builder, plan_of(loaded.shot, "main"))), Names{"b"});
  EXPECT_EQ(object_names(build_scene(builder, plan_of(loaded.shot, "none"))), Names{});
}

TEST(SelectionOfLoops, TakesAllElementsOrOne) {
  const loading::Loaded loaded = loaded_scene(
      "volume a = level_set(sphere(1m), voxel: 20cm)\n"
      "light lamp[x in [2, 3, 4]] = sphere(center: (x * 1m, 0, 0), radius: 10cm)\n"
      "render all { lights lamp }\nrender one { lights [lamp[1]] }\n");
  const auto names = [&](const char* render, const NamedValues& settings = {}) {
    Names all;
    const PicturePlan plan = plan_of(loaded.shot, render, settings);
    for (const auto& [name, light] : plan.shown->lights) all.push_back(name);
    return all;
  };
  EXPECT_EQ(names("all"), (Names{"lamp[0]", "lamp[1]", "lamp[2]"}));
  EXPECT_EQ(names("one"), Names{"lamp[1]"});
  EXPECT_EQ(names("one", {{"lights", List{"lamp"}}}).size(), 3u);
}

TEST(SelectionOfPlacement, IgnoresWhatIsOmitted) {
  const loading::Loaded loaded = loaded_scene(
      "volume rock = level_set(box(size: (4, 4, 4)), voxel: 20cm)\n"
      "volume ball = level_set(sphere(1m).translate((9, 0, 0)), voxel: 20cm)\n"
      "mesh rock_mesh on rock {}\nmesh ball_mesh on ball {}\n"
      "object cliff on rock_mesh {}\nobject globe on ball_mesh {}\n"
      "light lamp = sphere(center: (0.1, 0, 0), radius: 10cm)\ncamera main { eye (0.5, 0, 0) }\n"
      "render all {}\nrender globe { objects globe  lights [] }\n");
  const auto mistakes = [&](const char* render) {
    Diagnostics found;
    const PicturePlan plan = plan_of(loaded.shot, render);
    loading::check_placement(loaded, {"main", loading::Accuracy::exact, plan.shown.get()}, found);
    size_t errors = 0;
    for (const Diagnostic& each : found.all()) errors += each.severity == Severity::error;
    return errors;
  };
  EXPECT_EQ(mistakes("all"), 2u);
  EXPECT_EQ(mistakes("globe"), 0u);
}

}  // namespace
}  // namespace vug::picture
