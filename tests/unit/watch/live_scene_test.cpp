// SPDX-License-Identifier: Apache-2.0
// A live scene: after each edit its picture has the bytes of a new render, and only the products
// that the edit affects are made.
#include <vug/base/atomic_file.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/loading/load.h>
#include <vug/picture/render_job.h>
#include <vug/watch/live_scene.h>

#include <gtest/gtest.h>

#include <map>

namespace vug::watch {
namespace {

/// A scene whose parts can be edited one by one.
struct Text {
  std::map<std::string, std::string> parts = {
      {"radius", "50cm"},   {"block", "(1, 0, 0)"}, {"lamp", "(0, 2, 1)"},
      {"eye", "(0, 1, 4)"}, {"albedo", "0.5"},      {"spacing", "20cm"},
      {"comment", ""},      {"exposure", "0"},      {"pebbles", "3"}};

  std::string text() const {
    const auto p = [&](const char* name) { return parts.at(name); };
    return "# " + p("comment") + "\n" + "volume ball = level_set(sphere(" + p("radius") +
           "), voxel: 10cm)\n" +
           "mesh ball on ball { }\n"
           "cells skin on ball { spacing " +
           p("spacing") +
           " run random_color(share: 20%, from: (0.6, 0.5, 0.4), to: (0.9, 0.8, 0.7)), voronoi }\n"
           "volume block = level_set(box(size: (0.4, 0.4, 0.4)).translate(" +
           p("block") +
           "), voxel: 10cm)\n"
           "material stone = lambert(albedo: (0.5, " +
           p("albedo") +
           ", 0.5))\n"
           "object ball on skin { material stone }\n"
           "mesh block on block { }\n"
           "object block on block { material stone }\n"
           "volume pebble = level_set(sphere(10cm), voxel: 5cm)\n"
           "mesh pebble on pebble { }\n"
           "object pebble on pebble { }\n"
           "place pebbles { of pebble at [for i in 0.." +
           p("pebbles") +
           " : (i * 0.3 - 0.5, -0.5, 0.8)] }\n"
           "light lamp = sphere(center: " +
           p("lamp") +
           ", radius: 20cm)\n"
           "light sky = sky()\n"
           "camera main { eye " +
           p("eye") +
           " target (0, 0, 0) }\n"
           "render main { size 32x18 spp 4 exposure " +
           p("exposure") + " }\n";
  }
};

image::Image new_picture(const std::string& text) {
  const loading::Loaded loaded = loading::load_text(text, "scene.vug");
  EXPECT_TRUE(loaded.usable()) << loaded.report();
  building::Builder builder(loaded.shot);
  return *picture::render_picture(builder, picture::plan_picture(loaded.shot)).image;
}

class LiveScenes : public testing::Test {
 protected:
  /// Saves the text and renders it.
  Work save(const Text& text) {
    write_text(file_, text.text());
    if (!scene_.load(std::make_shared<Progress>())) {
      ADD_FAILURE() << scene_.report();
      return {};
    }
    image_ = scene_.render().front().image;
    return scene_.work();
  }

  ScratchFolder folder_{"vug_live_test"};
  std::filesystem::path file_ = folder_.file("scene.vug");
  LiveScene scene_{file_, {}};
  std::optional<image::Image> image_;
};

TEST_F(LiveScenes, OnlyAffectedProductsAreMade) {
  Text text;
  const Work first = save(text);
  EXPECT_EQ(first.products.level_sets, 3u);
  EXPECT_GT(first.samples, 0u);

  text.parts["lamp"] = "(1, 2, 1)";
  const Work lamp = save(text);
  EXPECT_EQ(lamp.products.total(), 0u);
  EXPECT_EQ(lamp.trees.built, 0u);
  EXPECT_GT(lamp.trees.reused, 0u);
  EXPECT_EQ(lamp.samples, 32u * 18 * 4);

  text.parts["eye"] = "(0.5, 1, 4)";
  const Work eye = save(text);
  EXPECT_EQ(eye.products.total(), 0u);
  EXPECT_EQ(eye.trees.built + eye.trees.reused, 0u);

  text.parts["comment"] = "another comment\n# of two lines";
  text.parts["exposure"] = "1";
  const Work comment = save(text);
  EXPECT_EQ(comment.products.total(), 0u);
  EXPECT_EQ(comment.samples, 0u);

  text.parts["albedo"] = "0.3";
  const Work albedo = save(text);
  EXPECT_EQ(albedo.products.total(), 0u);
  EXPECT_EQ(albedo.trees.built, 0u);

  text.parts["block"] = "(1, 0.2, 0)";
  const Work block = save(text);
  EXPECT_EQ(block.products.level_sets, 1u);
  EXPECT_EQ(block.products.meshes, 1u);
  EXPECT_EQ(block.products.cell_layers, 0u);
  EXPECT_EQ(*image_, new_picture(text.text()));
}

TEST_F(LiveScenes, EveryEditGivesThePictureOfANewRender) {
  const std::map<std::string, std::vector<std::string>> choices = {
      {"radius", {"50cm", "60cm"}},
      {"block", {"(1, 0, 0)", "(-1, 0.3, 0)"}},
      {"lamp", {"(0, 2, 1)", "(1, 2, 1)", "(-1, 1, 2)"}},
      {"eye", {"(0, 1, 4)", "(1, 1, 3)"}},
      {"albedo", {"0.5", "0.2"}},
      {"spacing", {"20cm", "15cm"}},
      {"comment", {"", "x\n\n", "y"}},
      {"exposure", {"0", "-1"}},
      {"pebbles", {"2", "3"}}};
  RandomStream random(RandomKey(3));
  Text text;
  for (int step = 0; step < 20; ++step) {
    auto edit = choices.begin();
    std::advance(edit, random.below(static_cast<uint32_t>(choices.size())));
    text.parts[edit->first] =
        edit->second[random.below(static_cast<uint32_t>(edit->second.size()))];
    with_threads(std::array{1, 2, 7}[random.below(3)], [&] { save(text); });
    ASSERT_EQ(*image_, new_picture(text.text())) << "step " << step << ", " << edit->first;
  }
}

TEST_F(LiveScenes, AnEditOfABlockComputesThePartsAroundIt) {
  const auto rock = [](const std::string& at) {
    return "let block = box(size: (0.8, 0.8, 0.8)).rotate(angle: 20deg)\n"
           "let heap = union([block.translate((-4, 0.5, -4)), block.translate(" +
           at +
           ")])\n"
           "volume rock = level_set(union([box(size: (12, 0.6, 12)), heap], blend: smooth(5cm)), "
           "voxel: 8cm)\n"
           "mesh rock on rock { }\n"
           "object rock on rock { }\n"
           "light sky = sky()\n"
           "camera main { eye (0, 5, 9) target (0, 0, 0) }\n"
           "render main { size 32x18 spp 1 }\n";
  };
  const auto save_rock = [&](const std::string& at) {
    write_text(file_, rock(at));
    EXPECT_TRUE(scene_.load(std::make_shared<Progress>())) << scene_.report();
    EXPECT_EQ(scene_.render().front().image, new_picture(rock(at))) << at;
    return scene_.work().parts;
  };
  const building::PartCounts all = save_rock("(4, 0.5, 4)");
  EXPECT_GT(all.blocks.evaluated, 30u);
  EXPECT_EQ(all.blocks.reused, 0u);
  EXPECT_EQ(all.groups.reused, 0u);
  const building::PartCounts moved = save_rock("(4, 0.5, 4.3)");
  EXPECT_GT(moved.blocks.evaluated, 0u);
  EXPECT_LT(moved.blocks.evaluated, all.blocks.evaluated / 2);
  LiveScene fresh(file_, {});
  ASSERT_TRUE(fresh.load(std::make_shared<Progress>()));
  fresh.render();
  EXPECT_EQ(moved.blocks.evaluated + moved.blocks.reused, fresh.work().parts.blocks.evaluated);
  EXPECT_EQ(moved.groups.evaluated + moved.groups.reused, fresh.work().parts.groups.evaluated);
  EXPECT_GT(moved.groups.evaluated, 0u);
  EXPECT_LT(moved.groups.evaluated, all.groups.evaluated / 2);
  const building::PartCounts undone = save_rock("(4, 0.5, 4)");
  EXPECT_EQ(undone.blocks.evaluated, 0u);
  EXPECT_EQ(undone.groups.evaluated, 0u);
  EXPECT_EQ(undone.groups.reused, all.groups.evaluated);
}

TEST_F(LiveScenes, ALookHasItsOwnEyeAndKeepsThePicture) {
  Text text;
  save(text);
  ViewRequest look;
  viewport::View& view = look.view;
  view = scene_.view();
  EXPECT_EQ(scene_.camera_name(), "main");
  EXPECT_NEAR((view.eye - Vec3d(0, 1, 4)).length(), 0, 1e-6);
  const Vec3d there = (view.target - view.eye).normalized();
  EXPECT_NEAR((there - Vec3d(0, -1, -4).normalized()).length(), 0, 1e-5);
  EXPECT_NEAR(view.fov, kPi / 3, 1e-4);
  look.width = 32, look.height = 18;
  const std::string own = scene_.look(look);
  ViewRequest other = look;
  other.view.eye.x = 2;
  EXPECT_NE(scene_.look(other), own);
  EXPECT_EQ(save(text).samples, 0u) << "the picture is still known";
}

TEST_F(LiveScenes, ClayHasNoMaterialsAndLights) {
  ViewRequest look{.view = {{0, 1, 4}}, .mode = viewport::Mode::clay, .width = 32, .height = 18};
  Text text;
  std::vector<std::string> clay;
  for (const char* albedo : {"0.5", "0.1"}) {
    text.parts["albedo"] = albedo;
    text.parts["lamp"] = std::string("(") + albedo + ", 2, 1)";
    LiveScene scene(file_, {});
    write_text(file_, text.text());
    ASSERT_TRUE(scene.load(std::make_shared<Progress>()));
    clay.push_back(scene.look(look));
  }
  EXPECT_EQ(clay[0], clay[1]);
  look.view.eye.x = 1;
  ASSERT_TRUE(scene_.load(std::make_shared<Progress>()));
  EXPECT_NE(scene_.look(look), clay[0]);
}

TEST_F(LiveScenes, AnErrorKeepsTheLastVersion) {
  Text text;
  save(text);
  write_text(file_, text.text() + "object wrong on nowhere { }\n");
  EXPECT_FALSE(scene_.load(std::make_shared<Progress>()));
  ASSERT_TRUE(scene_.problems().has_errors());
  EXPECT_EQ(scene_.problems().all().front().where.line, 18);
  EXPECT_EQ(*scene_.render().front().image, *image_);
  const Work again = save(text);
  EXPECT_EQ(again.products.total(), 0u);
  EXPECT_EQ(again.samples, 0u);
}

TEST_F(LiveScenes, AMissingFileIsWatched) {
  EXPECT_EQ(scene_.files(), std::vector{file_});
  EXPECT_THROW(scene_.load(std::make_shared<Progress>()), Error);
  EXPECT_EQ(scene_.files(), std::vector{file_});
}

TEST_F(LiveScenes, CancelledWorkContinues) {
  Text text;
  save(text);
  text.parts["block"] = "(1, 0.2, 0)";
  write_text(file_, text.text());
  const auto progress = std::make_shared<Progress>();
  ASSERT_TRUE(scene_.load(progress));
  progress->cancel();
  EXPECT_THROW(scene_.render(), Error);
  const Work work = save(text);
  EXPECT_EQ(work.products.cell_layers, 0u);
  EXPECT_EQ(*image_, new_picture(text.text()));
}

}  // namespace
}  // namespace vug::watch
