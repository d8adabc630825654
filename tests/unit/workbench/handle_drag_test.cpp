// SPDX-License-Identifier: Apache-2.0
// Drags of handles: the picture of the new numbers is below the mouse.
#include <vug/base/rng.h>
#include <vug/language/workspace.h>
#include <vug/viewport/view.h>
#include <vug/workbench/handle_drag.h>
#include <vug/workbench/scene_overlay.h>

#include <gtest/gtest.h>

namespace vug::workbench {
namespace {

/// A texts' statement in its first line.
language::StatementHandles handles_in(const std::string& text) {
  language::Workspace workspace;
  workspace.open("/scenes/main.vug", text);
  return language::handles_at(*workspace.analyse("/scenes/main.vug"), 1);
}

/// The handle with other numbers.
language::LiteralHandle with_numbers(language::LiteralHandle handle,
                                     const std::vector<double>& numbers) {
  for (size_t i = 0; i < numbers.size(); ++i) handle.numbers[i].value = numbers[i];
  return handle;
}

viewport::ScreenView view_from(const Vec3d& eye) {
  return {viewport::camera_of({eye, {0, 0.5, 0}, 1.0}), 640, 360};
}

TEST(HandleDrag, PointsAndDirectionsFollowTheMouse) {
  const auto lamp =
      handles_in("light lamp = spot(center: (20cm, 50cm, -0.3m), direction: (0.4, -1, 0.2))\n");
  const auto moved = handles_in(
      "let a = sphere(radius: 30cm).translate((0.2, 0.1, 0.3)).rotate(angle: 40deg).scale(by: "
      "2)\n");
  RandomStream random{RandomKey(3)};
  for (int i = 0; i < 60; ++i) {
    const viewport::ScreenView view =
        view_from({random.uniform() * 4 - 2, random.uniform() * 2, 3 + random.uniform() * 3});
    const Vec2d offset(random.uniform() * 160 - 80, random.uniform() * 160 - 80);
    for (const auto* handle : {&lamp.find("center"), &moved.find("by")}) {
      const auto numbers = dragged_numbers(*handle, view, offset);
      ASSERT_TRUE(numbers);
      // With the rounding of the texts.
      std::vector<double> rounded;
      for (const std::string& text :
           language::number_texts(*handle, *numbers, number_step(*handle, view)))
        rounded.push_back(scene::read_number(text)->value);
      const Vec2d expected = *view.project(handle->position()) + offset;
      const Vec2d found = *view.project(with_numbers(*handle, rounded).position());
      EXPECT_LT((found - expected).length(), 1) << handle->name;
    }
    // An arrow reaches the mouse only where its length allows it.
    const language::LiteralHandle& arrow = lamp.find("direction");
    const Vec2d small = offset * 0.1;
    const auto numbers = dragged_numbers(arrow, view, small);
    ASSERT_TRUE(numbers);
    const language::LiteralHandle turned = with_numbers(arrow, *numbers);
    EXPECT_NEAR(turned.vector().length(), arrow.vector().length(), 1e-9);
    const Vec2d tip = *view.project(grip_point(turned, view));
    const Vec2d anchor = *view.project(arrow.position());
    const Vec2d expected = *view.project(grip_point(arrow, view)) + small;
    if ((expected - anchor).length() < 0.8 * kHandlePixels) {
      EXPECT_LT((tip - expected).length(), 1);
    }
  }
}

TEST(HandleDrag, AnAxisChangesOneNumber) {
  const auto lamp = handles_in("light lamp = sphere(center: (20cm, 50cm, -0.3m))\n");
  const auto numbers = dragged_numbers(lamp.find("center"), view_from({1, 1, 4}), {0, -50}, 1);
  ASSERT_TRUE(numbers);
  EXPECT_DOUBLE_EQ((*numbers)[0], 0.2);
  EXPECT_DOUBLE_EQ((*numbers)[2], -0.3);
  EXPECT_GT((*numbers)[1], 0.6);
  EXPECT_FALSE(dragged_numbers(lamp.find("center"), view_from({0.2, 0.5, 4}), {5, 0}, 2))
      << "an axis along the line of sight";
}

TEST(HandleDrag, LengthsKeepTheirLine) {
  const auto ball = handles_in("let ball = sphere(radius: 50cm).translate((0, 0.5, 0))\n");
  const language::LiteralHandle& radius = ball.find("radius");
  const viewport::ScreenView view = view_from({0, 0.5, 4});
  const auto numbers = dragged_numbers(radius, view, {40, 0});
  ASSERT_TRUE(numbers);
  const Vec2d expected = *view.project(radius.position()) + Vec2d(40, 0);
  EXPECT_LT((*view.project(with_numbers(radius, *numbers).position()) - expected).length(), 1e-2);
  EXPECT_EQ(dragged_numbers(radius, view, {-2000, 0})->at(0), 0) << "not negative";
}

TEST(SceneOverlays, AreHitAtTheirGripsAndAxes) {
  const auto lamp = handles_in("light lamp = sphere(center: (0, 50cm, 0))\n");
  const viewport::Gizmo mark{"light", "lamp", {0, 0.5, 0}, std::nullopt, lamp.extent};
  const SceneOverlay overlay = overlay_of(lamp, {mark}, view_from({0, 0.5, 4}));
  ASSERT_EQ(overlay.handles.size(), 1u);
  const Vec2d at = overlay.handles[0].at;
  EXPECT_NEAR(at.x, 320, 0.1);
  EXPECT_NEAR(at.y, 180, 0.1);
  EXPECT_EQ(handle_at(overlay, at + Vec2d(3, 0), 8)->axis, std::nullopt);
  EXPECT_EQ(handle_at(overlay, at + Vec2d(kHandlePixels, 2), 8)->axis, 0);
  EXPECT_EQ(handle_at(overlay, at + Vec2d(0, -kHandlePixels), 8)->axis, 1);
  EXPECT_FALSE(handle_at(overlay, at + Vec2d(30, 30), 8));
  ASSERT_TRUE(gizmo_at(overlay, at, 8));
  EXPECT_TRUE(gizmo_at(overlay, at, 8)->selected);
  EXPECT_TRUE(overlay_of(lamp, {mark}, view_from({0, 0.5, -4})).handles.size() == 1);
}

}  // namespace
}  // namespace vug::workbench
