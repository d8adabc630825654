// SPDX-License-Identifier: Apache-2.0
// Animated scenes: static products are built once, and files are named by their frame.
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/building/builder.h>
#include <vug/picture/frame_sequence.h>
#include <vug/picture/motion.h>
#include <vug/shot/queries.h>

namespace vug::picture {
namespace {

constexpr const char* kScene = R"(
let way = keys(1: 0m, 11: 5m)
grammar pile { axiom Stone*3; Stone -> + sphere(radius: 0.3..0.6) label random }
volume rock = level_set(pile, voxel: 20cm)
volume ball = level_set(sphere(50cm).translate((way, 0, 0)), voxel: 20cm)
mesh stone on rock {}
mesh roller on ball {}
object a on stone { material lambert(albedo: (0.5, 0.5, 0.5)) }
object b on roller { material lambert(albedo: (0.1 * frame, 0, 0)) }
camera main { eye (way, 2, 9) }
camera still { eye (0, 2, 9) }
)";

loading::Loaded at(double frame, const loading::SceneSource& source) {
  loading::Loaded loaded = source.at(frame);
  EXPECT_EQ(loaded.report(), "");
  return loaded;
}

TEST(Sequence, StaticPlansAreTheSameObject) {
  const loading::SceneSource source(kScene, "t.vug"), other(kScene, "t.vug");
  const shot::Shot one = at(1, source).shot, two = at(2, source).shot, alone = at(2, other).shot;
  EXPECT_TRUE(one.animated);
  ASSERT_EQ(two.volumes.size(), 2u);
  EXPECT_EQ(one.volumes[0], two.volumes[0]);
  EXPECT_NE(one.volumes[1], two.volumes[1]);
  EXPECT_EQ(one.meshes[0], two.meshes[0]);
  EXPECT_NE(one.meshes[1], two.meshes[1]);
  EXPECT_EQ(one.objects[0].material, two.objects[0].material);
  EXPECT_NE(one.objects[1].material, two.objects[1].material);
  EXPECT_NE(one.cameras[0].camera, two.cameras[0].camera);
  EXPECT_EQ(one.cameras[1].camera, two.cameras[1].camera);
  EXPECT_FLOAT_EQ(two.cameras[0].camera->position().x, 0.5f);
  // The shot equals that of loading this frame alone.
  EXPECT_EQ(two.recipe, alone.recipe);
  EXPECT_EQ(two.derivations.size(), alone.derivations.size());
  EXPECT_EQ(two.objects.size(), alone.objects.size());
  ASSERT_EQ(two.cameras.size(), alone.cameras.size());
  for (size_t i = 0; i < two.cameras.size(); ++i)
    EXPECT_EQ(two.cameras[i].name, alone.cameras[i].name);
  EXPECT_FALSE(loading::load_text("camera main { eye (0, 2, 9) }", "t.vug").shot.animated);
}

TEST(Sequence, ABuilderKeepsStaticProducts) {
  const loading::SceneSource source(kScene, "t.vug");
  const loading::Loaded one = at(1, source), two = at(2, source);
  building::Builder first(one.shot);
  const auto stone = first.mesh(one.shot.meshes[0]), roller = first.mesh(one.shot.meshes[1]);
  building::Builder second(two.shot);
  second.reuse_from(std::move(first));
  EXPECT_EQ(second.mesh(two.shot.meshes[0]), stone);
  EXPECT_NE(second.mesh(two.shot.meshes[1]), roller);
  EXPECT_NEAR(second.mesh(two.shot.meshes[1])->positions[0].x - roller->positions[0].x, 0.5, 0.5);
}

TEST(Sequence, AMovingCameraIsBlurredWhileItsShutterIsOpen) {
  const std::string text =
      "camera main { eye (keys(1: 0m, 3: 2m), 0, 5)  target (0, 0, -9)  shutter 0.5 }\n"
      "camera rest { eye (1, 0, 5)  shutter 0.5 }\n"
      "camera fast { eye (keys(1: 0m, 3: 2m), 0, 5)  target (0, 0, -9) }\n";
  const loading::SceneSource source(text, "t.vug");
  const shot::Shot shot = at(2, source).shot;
  PictureOptions options;
  options.source = &source;
  const auto camera = [&](const std::string& name) {
    options.camera = name;
    const PicturePlan plan = plan_picture(shot, options);
    return animated_camera(shutter_samples(shot, plan), plan);
  };
  const render::CameraPtr main = camera("main");
  ASSERT_TRUE(main->moves());
  const auto x_at = [&](float time) {
    return main->ray_at(time, {0.5f, 0.5f}, 1, {0.5f, 0.5f}).origin.x;
  };
  EXPECT_FLOAT_EQ(x_at(0), 1);
  EXPECT_FLOAT_EQ(x_at(0.5f), 1.25f);
  EXPECT_FLOAT_EQ(x_at(1), 1.5f);
  EXPECT_FALSE(camera("rest")->moves());
  EXPECT_FALSE(camera("fast")->moves());
  options.source = nullptr;
  EXPECT_FALSE(camera("main")->moves());
}

TEST(Sequence, InstancesMoveWhileTheShutterIsOpen) {
  const std::string text =
      "volume ball = level_set(sphere(20cm), voxel: 10cm)\n"
      "mesh round on ball {}\n"
      "object stone on round {}\n"
      "object rock on round {}\n"
      "object ember on round { emission (frame, 1, 1) }\n"
      "place rolling { of stone  at [(0, 0, 0), (2 * frame, 0, 0)] }\n"
      "place lying { of rock  at (0, 1, 0) }\n"
      "place glowing { of ember  at (0, 2, 0) }\n"
      "camera main { shutter 0.5 }\n"
      "render main { size 4x4  spp 1  layers [\"beauty\", \"motion\"] }\n";
  const loading::SceneSource source(text, "t.vug");
  const loading::Loaded loaded = at(3, source);
  PictureOptions options;
  options.source = &source;
  building::Builder builder(loaded.shot);
  const PictureJob job = prepare_picture(builder, plan_picture(loaded.shot, options), false);
  ASSERT_EQ(job.scene.objects.size(), 4u);
  const auto x_at = [&](size_t object, float time) {
    return job.scene.objects[object].instance->at(time).origin.x;
  };
  EXPECT_FLOAT_EQ(x_at(0, 1), 0);
  EXPECT_FLOAT_EQ(x_at(1, 0), 6);
  EXPECT_FLOAT_EQ(x_at(1, 0.5f), 6.5f);
  EXPECT_FLOAT_EQ(x_at(1, 1), 7);
  // The others: next to a rolling instance, in another declaration, and with only a changing light.
  for (const size_t at_rest : {0u, 2u, 3u})
    EXPECT_FALSE(job.scene.objects[at_rest].instance->moves()) << at_rest;
  ASSERT_TRUE(job.options.motion_step);
  ASSERT_TRUE(job.options.motion_step->transforms.count(1));
  EXPECT_FLOAT_EQ(job.options.motion_step->transforms.at(1).first.origin.x, 6);
  EXPECT_FLOAT_EQ(job.options.motion_step->transforms.at(1).second.origin.x, 8);
}

TEST(Sequence, ASourceReportsTheFirstFaultOfAFrame) {
  const loading::SceneSource source("camera main { eye (0, 2, 9)  shutter 3 - frame }\n", "t.vug");
  EXPECT_EQ(source.shot_at(2)->cameras.size(), 1u);
  try {
    source.shot_at(4);
    ADD_FAILURE() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_EQ(error.where().line, 1);
    EXPECT_EQ(error.context(), (std::vector<std::string>{"loading frame 4"}));
  }
}

TEST(Sequence, UndeclaredMeshesAreKeptToo) {
  const std::string text =
      "volume rock = level_set(sphere(1m), voxel: 20cm)\n"
      "camera main { eye (frame, 2, 9) }\n";
  const loading::SceneSource source(text, "t.vug");
  const loading::Loaded one = at(1, source), two = at(2, source);
  building::Builder first(one.shot);
  const auto mesh = first.mesh(shot::shown_meshes(one.shot).at(0));
  building::Builder second(two.shot);
  second.reuse_from(std::move(first));
  EXPECT_EQ(second.mesh(shot::shown_meshes(two.shot).at(0)), mesh);
}

TEST(Sequence, RangesOfFrames) {
  EXPECT_EQ(parse_frames("7"), (std::vector<int>{7}));
  EXPECT_EQ(parse_frames("-1..2"), (std::vector<int>{-1, 0, 1, 2}));
  EXPECT_EQ(parse_frames("1..8x3"), (std::vector<int>{1, 4, 7}));
  EXPECT_EQ(parse_frames("9,1..3"), (std::vector<int>{9, 1, 2, 3}));
  for (const char* bad : {"", "a", "1..", "3..1", "1..5x0", "1..5x", "1-5", "1..3,2", "1..3 ",
                          "1..99999999", "1..3,"})
    EXPECT_THROW(parse_frames(bad), Error) << bad;
}

TEST(Sequence, NamesWithTheFrame) {
  EXPECT_EQ(frame_path("out/cave.####.exr", 7), "out/cave.0007.exr");
  EXPECT_EQ(frame_path("cave_%04d.exr", 12345), "cave_12345.exr");
  EXPECT_EQ(frame_path("c%d.exr", 7), "c7.exr");
  EXPECT_EQ(frame_path("50%_#.exr", 3), "50%_3.exr");
  EXPECT_EQ(frame_path("c.###.exr", -3), "c.-03.exr");
  EXPECT_TRUE(has_frame_number("out/c.#.png") && has_frame_number("c%04d.png"));
  EXPECT_FALSE(has_frame_number("out.#/c.png") || has_frame_number("c50%.png"));
  for (const char* bad : {"cave.exr", "####/cave.exr", "a#b#.exr"})
    EXPECT_THROW(frame_path(bad, 1), Error) << bad;
}

}  // namespace
}  // namespace vug::picture
