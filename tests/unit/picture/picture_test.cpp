// SPDX-License-Identifier: Apache-2.0
// The camera of a render without a camera of its own.
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/loading/load.h>
#include <vug/picture/picture_output.h>
#include <vug/picture/picture_plan.h>

#include <algorithm>
#include <set>

namespace vug::picture {
namespace {

constexpr const char* kPictureScene = R"(
camera left  { eye (-5, 0, 0) }
camera right { eye (5, 0, 0) }
camera above { eye (0, 5, 0)  target (1, 0, 0) }
render plain { spp 1 }
render right { spp 1 }
render above { spp 1  camera left }
)";

/// Name of the camera of the render with that name.
std::string camera_of(const shot::Shot& shot, const std::string& render,
                      const std::string& camera = {}) {
  PictureOptions options;
  options.render = render;
  options.camera = camera;
  const PicturePlan plan = plan_picture(shot, options);
  for (const shot::CameraPlan& each : shot.cameras)
    if (each.camera == plan.render.settings.camera) return each.name;
  return "";
}

TEST(RenderPlan, TakesItsCameraElseTheOneOfItsNameElseTheFirst) {
  const loading::Loaded loaded = loading::load_text(kPictureScene, "t.vug");
  ASSERT_EQ(loaded.report(), "");
  EXPECT_EQ(camera_of(loaded.shot, "plain"), "left");
  EXPECT_EQ(camera_of(loaded.shot, "right"), "right");
  EXPECT_EQ(camera_of(loaded.shot, "above"), "left");
  EXPECT_EQ(camera_of(loaded.shot, "above", "above"), "above");
}

TEST(RenderPlan, WithoutARenderTheCameraMainGoesFirst) {
  const loading::Loaded loaded =
      loading::load_text("camera a { eye (1, 0, 0) }\ncamera main { eye (0, 0, 1) }\n", "t.vug");
  ASSERT_EQ(loaded.report(), "");
  EXPECT_EQ(camera_of(loaded.shot, ""), "main");
}

TEST(PicturePlan, DenoisingAddsTheLayersThatItNeeds) {
  using Layers = std::vector<std::string>;
  const auto layers = [](const std::string& settings) {
    const loading::Loaded loaded =
        loading::load_text("render main { spp 8  " + settings + " }\n", "t.vug");
    EXPECT_EQ(loaded.report(), "");
    return plan_picture(loaded.shot, {}).render.settings.layers;
  };
  EXPECT_EQ(layers("denoise true  layers [\"beauty\", \"Z\"]"),
            (Layers{"beauty", "Z", "albedo", "N", "variance"}));
  EXPECT_EQ(layers("layers [\"beauty\", \"Z\"]"), (Layers{"beauty", "Z"}));
  EXPECT_EQ(layers("denoise true  layers [\"all\"]"), Layers{"all"});
  EXPECT_EQ(layers("denoise true"), Layers{});  // The usual layers, which contain them.
}

TEST(PicturePlan, OptionsReplaceSettingsOfTheBlock) {
  const loading::Loaded loaded = loading::load_text(
      "render main { size 20x10  spp 3  tiled true  noise 5%  layers [\"beauty\", \"Z\"] }\n",
      "t.vug");
  ASSERT_EQ(loaded.report(), "");
  PictureOptions options;
  options.settings = {{"spp", 7}, {"tiled", false}, {"crop", List{1, 2, 3, 4}}, {"spp", 9}};
  const PicturePlan plan = plan_picture(loaded.shot, options);
  const shot::RenderSettings& settings = plan.render.settings;
  EXPECT_EQ(settings.spp, 9);
  EXPECT_FALSE(settings.tiled);
  EXPECT_EQ(settings.crop, (std::vector<int>{1, 2, 3, 4}));
  EXPECT_EQ(settings.size, (std::vector<int>{20, 10}));
  EXPECT_EQ(settings.noise, 0.05);
  EXPECT_EQ(settings.layers, (std::vector<std::string>{"beauty", "Z"}));
  EXPECT_EQ(plan.option_for("spp"), "--spp");
  EXPECT_EQ(plan.option_for("size"), "");
}

TEST(PicturePlan, InvalidSettingsAreReported) {
  const auto refused = [](const NamedValues& settings) -> std::string {
    PictureOptions options;
    options.settings = settings;
    try {
      plan_picture({}, options);
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  EXPECT_EQ(refused({{"sp", 7}}), "'render' has no parameter 'sp'");
  EXPECT_EQ(refused({{"spp", 0}}), "'spp' must be at least 1, not 0");
  EXPECT_EQ(refused({{"tiled", 1}}), "'tiled' expects true or false, not a number");
  EXPECT_EQ(refused({{"size", List{8}}}), "'size' must be a width and a height");
  EXPECT_EQ(refused({{"crop", List{8, 9}}}), "'crop' must be left, top, right and bottom");
}

TEST(PicturePlan, TheHashDependsOnEverySettingThatAnOptionReplaces) {
  const auto hash = [](const NamedValues& settings) {
    PictureOptions options;
    options.settings = {{"spp", 3}};  // so that no quality sets others
    options.settings.insert(options.settings.end(), settings.begin(), settings.end());
    const shot::Shot shot;
    std::string all;
    for (const auto& [name, text] : identifying_metadata(shot, plan_picture(shot, options)))
      all += name + "=" + text + "\n";
    return all;
  };
  std::set<std::string> hashes = {hash({})};
  for (const ParamInfo& info : shot::render_schema().info().params) {
    if (info.type == "true or false")
      hashes.insert(hash({{info.name, info.fallback == "false"}}));
    else if (info.type == "number")
      hashes.insert(hash({{info.name, std::max(info.min, 0.5)}}));
    else if (info.type == "number or name")
      hashes.insert(hash({{info.name, Value::Name{info.choices.back()}}}));
    else if (info.type == "whole number")
      hashes.insert(hash({{info.name, 5}}));
    else if (info.type == "text")
      hashes.insert(hash({{info.name, info.name == "air" ? "none" : "other"}}));
    else if (info.type == "name")
      hashes.insert(hash({{info.name, Value::Name{info.choices.back()}}}));
    else
      hashes.insert(info.name);  // lists and objects
  }
  EXPECT_EQ(hashes.size(), shot::render_schema().info().params.size() + 1);
}

TEST(PictureOutput, SurvivesThePartialRender) {
  PictureOutput output;
  output.settings.exposure = {shot::Exposure::Mode::stops, -1.3};
  output.settings.compensation = 0.5;
  output.settings.half = false;
  output.settings.denoise = true;
  output.settings.working_space = image::WorkingSpace::acescg;
  output.settings.view = "standard";
  output.config = "a.ocio";
  output.metadata = {{"vug:seed", "7"}};
  output.camera.emplace().world_to_camera[3] = 0.1f;
  const shot::NamedTexts attributes = to_header_attributes(output);
  EXPECT_EQ(attributes.at(0), (std::pair<std::string, std::string>{"exposure", "-1.3"}));
  const PictureOutput again = from_header_attributes(attributes);
  EXPECT_EQ(to_header_attributes(again), attributes);
  EXPECT_EQ(again.settings.working_space, image::WorkingSpace::acescg);
  EXPECT_THROW(from_header_attributes({{"exposure", "99"}}), Error);
  for (const std::string& name : shot::exposure_names())
    EXPECT_EQ(to_header_attributes(from_header_attributes({{"exposure", name}})).at(0).second,
              name);
}

}  // namespace
}  // namespace vug::picture
