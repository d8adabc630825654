// SPDX-License-Identifier: Apache-2.0
// A pixel leads to the object below it and to its declarations.
#include "scene.h"

#include <vug/viewport/preview_renderer.h>

namespace vug::viewport {
namespace {

std::vector<std::string> kinds_of(const Pick& pick) {
  std::vector<std::string> out;
  for (const DeclaredPlace& each : pick.declared) out.push_back(each.kind + " " + each.name);
  return out;
}

class Picking : public testing::Test {
 protected:
  void SetUp() override {
    PreviewRenderer renderer;
    renderer.set_scene(build(scene_text()));
    picture_ = renderer.render({std::nullopt, Mode::clay, 64, 36}, {1, 1, false}, false);
  }
  std::optional<Pick> at(const Vec3d& point) const {
    const PickScene& scene = picture_.scene;
    const auto film = scene.camera->project(Vec3f(point), static_cast<float>(scene.aspect));
    return pick(scene, static_cast<double>(film->x), static_cast<double>(film->y));
  }
  Preview picture_;
};

TEST_F(Picking, FindsTheObjectAndItsDeclarations) {
  const std::optional<Pick> ball = at({0, 0, 0});
  ASSERT_TRUE(ball);
  EXPECT_EQ(ball->object, "ball");
  EXPECT_EQ(ball->material, "stone");
  EXPECT_NEAR(ball->position.z, 0.5, 0.02);
  EXPECT_NEAR(ball->distance, 3.5, 0.02);
  EXPECT_NEAR(ball->normal.z, 1, 0.05);
  EXPECT_EQ(kinds_of(*ball), (std::vector<std::string>{"object ball", "mesh ball", "volume ball",
                                                       "material stone"}));
  EXPECT_EQ(ball->declared.front().where.line, 5);
  const std::optional<Pick> block = at({1.2, 0, 0.3});
  ASSERT_TRUE(block);
  EXPECT_EQ(block->declared.front().where.line, 8);
}

TEST_F(Picking, FindsThePlaceOfAnInstance) {
  const std::optional<Pick> pebble = at({0, -0.8, 0.5});
  ASSERT_TRUE(pebble);
  EXPECT_EQ(pebble->object, "pebbles");
  EXPECT_EQ(kinds_of(*pebble),
            (std::vector<std::string>{"place pebbles", "object pebble", "mesh pebble",
                                      "volume pebble", "material stone"}));
}

TEST_F(Picking, FindsNothingInTheBackground) { EXPECT_FALSE(pick(picture_.scene, 0.02, 0.02)); }

}  // namespace
}  // namespace vug::viewport
