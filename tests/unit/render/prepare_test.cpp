// SPDX-License-Identifier: Apache-2.0
// Prepared renders: their parts, their timings and repeated use.
#include <vug/base/error.h>
#include <vug/render/prepare.h>

#include <gtest/gtest.h>

#include "scenes.h"

namespace vug::render {
namespace {

/// A closed room with one opening to the sky, so that every step of the preparation has work.
Scene open_room() {
  mesh::Mesh walls = mesh::box_mesh({Vec3d(-2), Vec3d(2)});
  walls.triangles.pop_back();
  Scene scene;
  scene.camera = view({1, 0, 1.5}, {-1, 0, -1}, 1.2);
  scene.objects = {object(std::move(walls), 0.6)};
  scene.lights = {make_light("sky", {{"radiance", Vec3d(1)}}),
                  make_light("sphere", {{"center", Vec3d(-0.5, 0, -0.5)}, {"radius", 0.1}})};
  return scene;
}

TEST(Prepare, RendersTheSamePictureAnyNumberOfTimes) {
  const Scene scene = open_room();
  Options o = options(64, 64, 16, 4);
  const image::Image expected = render(scene, o);
  PreparedRender first = prepare(scene, o);
  const PreparedRender moved = std::move(first);
  EXPECT_EQ(render(moved), expected);
  EXPECT_EQ(render(moved), expected);
  o.threads = 3;
  EXPECT_EQ(render(prepare(scene, o)), expected);
}

TEST(Prepare, TimesTheStepsThatItRuns) {
  const Scene scene = open_room();
  const PreparationTimings large = prepare(scene, options(64, 64, 16, 4)).timings;
  EXPECT_GT(large.bvh, 0);
  EXPECT_GT(large.portals, 0);
  EXPECT_GT(large.training, 0);
  EXPECT_GT(large.bright_edges, 0);
  EXPECT_DOUBLE_EQ(large.total(), large.bvh + large.portals + large.training + large.bright_edges);
  Options o = options(8, 8, 1, 4);
  o.openings = false;
  const PreparationTimings small = prepare(scene, o).timings;
  EXPECT_EQ(small.portals, 0);
  EXPECT_EQ(small.bright_edges, 0);
}

TEST(Prepare, RunsItsStagesInOrder) {
  std::vector<std::string> stages;
  Progress progress([&](const std::string& stage, double) {
    if (stages.empty() || stages.back() != stage) stages.push_back(stage);
  });
  prepare(open_room(), options(64, 64, 16, 4), progress);
  EXPECT_EQ(stages, (std::vector<std::string>{"BVH and lights", "finding openings to the sky",
                                              "learning where light comes from",
                                              "looking for bright edges"}));
}

TEST(Prepare, PartsContinueWithWhatAnotherHasLearned) {
  const Scene scene = open_room();
  const Options o = options(64, 64, 16, 4);
  const PreparedRender whole = prepare(scene, o);
  ASSERT_TRUE(whole.learned && whole.learned->guiding);
  EXPECT_FALSE(whole.learned->portals.empty());
  std::vector<std::string> stages;
  Progress progress([&](const std::string& stage, double) { stages.push_back(stage); });
  const Region band{0, 16, 64, 32};
  const PreparedRender part = prepare(scene, o, {whole.learned, band}, progress);
  for (const std::string& stage : stages) {
    EXPECT_EQ(stage.find("learning"), std::string::npos);
    EXPECT_EQ(stage.find("openings"), std::string::npos);
  }
  for (int y = band.y0; y < band.y1; ++y)
    for (int x = 0; x < 64; ++x) EXPECT_EQ(part.edges.at(x, y), whole.edges.at(x, y));
  EXPECT_EQ(render(prepare(scene, o, {whole.learned, {}}, progress)), render(whole));
}

TEST(Prepare, RejectsInvalidOptions) {
  Scene scene = open_room();
  EXPECT_THROW(prepare(scene, options(0, 8, 1, 1)), Error);
  EXPECT_THROW(prepare(scene, options(8, 8, 0, 1)), Error);
  Options o = options(8, 8, 1, 1);
  o.crop = {4, 4, 9, 8};
  EXPECT_THROW(prepare(scene, o), Error);
  scene.camera = nullptr;
  EXPECT_THROW(prepare(scene, options(8, 8, 1, 1)), Error);
}

}  // namespace
}  // namespace vug::render
