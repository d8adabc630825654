// SPDX-License-Identifier: Apache-2.0
// The camera of a render without a camera of its own.
#include <gtest/gtest.h>
#include <vug/loading/load.h>
#include <vug/picture/picture.h>

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
  const shot::RenderPlan plan = render_plan(shot, options);
  for (const shot::CameraPlan& each : shot.cameras)
    if (each.camera == plan.camera) return each.name;
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

}  // namespace
}  // namespace vug::picture
