// SPDX-License-Identifier: Apache-2.0
// Motions of the eye of a viewport.
#include "scene.h"

namespace vug::viewport {
namespace {

constexpr View kView{{1, 2, 5}, {1, 1, 1}, 1.0};

double reach(const View& view) { return (view.eye - view.target).length(); }

TEST(View, OrbitKeepsTheDistanceAndReturns) {
  const View turned = orbit(kView, 0.7, 0.3);
  EXPECT_NEAR(reach(turned), reach(kView), 1e-9);
  EXPECT_EQ(turned.target, kView.target);
  EXPECT_GT((turned.eye - kView.eye).length(), 1);
  EXPECT_LT((orbit(turned, -0.7, -0.3).eye - kView.eye).length(), 1e-9);
  const View above = orbit(kView, 0, 9);
  EXPECT_LT((above.eye - above.target).normalized().y, 1);
}

TEST(View, PanMovesBothInThePlaneOfThePicture) {
  const View moved = pan(kView, 0.5, -0.25);
  const Vec3d by = moved.eye - kView.eye;
  EXPECT_LT((moved.target - kView.target - by).length(), 1e-12);
  EXPECT_NEAR(by.dot(kView.eye - kView.target), 0, 1e-9);
  EXPECT_NEAR(by.length(), reach(kView) * std::sqrt(0.3125), 1e-9);
  const View right = pan({{0, 0, 4}, {0, 0, 0}}, 0.5, 0.25);
  EXPECT_NEAR(right.eye.x, 2, 1e-12);
  EXPECT_NEAR(right.eye.y, 1, 1e-12);
}

TEST(View, DollyScalesTheDistanceAndNeverReachesTheTarget) {
  EXPECT_NEAR(reach(dolly(kView, 0.5)), reach(kView) / 2, 1e-12);
  EXPECT_GT(reach(dolly(kView, 0)), 0);
}

TEST(View, FrameShowsTheWholeBox) {
  const Box3d box({-2, -1, -3}, {4, 1, 0});
  const View view = frame(kView, box);
  EXPECT_EQ(view.target, box.center());
  const render::CameraPtr camera = camera_of(view);
  for (const double x : {-2, 4})
    for (const double y : {-1, 1})
      for (const double z : {-3, 0}) {
        const auto at = camera->project(Vec3f(Vec3d(x, y, z)), 1);
        ASSERT_TRUE(at);
        EXPECT_GE(std::min(at->x, at->y), 0);
        EXPECT_LE(std::max(at->x, at->y), 1);
      }
}

TEST(View, TheTextOfACameraHasTheSameView) {
  const View view{{1.5, 2, 5}, {0, 1, 0}, 60 * kPi / 180};
  EXPECT_EQ(camera_text(view, "main"),
            "camera main { eye (1.5, 2, 5)  target (0, 1, 0)  fov 60deg }");
  LiveText text("scene.vug", {});
  ASSERT_TRUE(
      text.load(scene_text() + camera_text(view, "other") + "\n", std::make_shared<Progress>()))
      << text.report();
  const View read = view_of(*text.loaded().shot.cameras.at(1).camera, 1);
  EXPECT_LT((read.eye - view.eye).length(), 1e-5);
  EXPECT_NEAR((read.target - read.eye).normalized().dot((view.target - view.eye).normalized()), 1,
              1e-6);
  EXPECT_NEAR(read.fov, view.fov, 1e-4);
}

}  // namespace
}  // namespace vug::viewport
