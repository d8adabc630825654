// SPDX-License-Identifier: Apache-2.0
// Shots as text, their files, and the sheet.
#include <gtest/gtest.h>
#include <vug/loading/load.h>
#include <vug/scout/contact_sheet.h>
#include <vug/scout/shot_text.h>

#include <cmath>

namespace vug::scout {
namespace {

TEST(ShotText, TheTextIsTheCameraOfThePose) {
  ScoutedShot shot;
  shot.candidate.pose = rounded({Vec3d(1.234567, 1.6, -8), 2.1, 0.2, 65 * kDegree});
  const loading::Loaded loaded = loading::load_text(shot_text(shot, 3, "my.vug"), "shot3.vug");
  ASSERT_TRUE(loaded.usable()) << loaded.report();
  ASSERT_EQ(loaded.shot.cameras.size(), 1u);
  EXPECT_EQ(loaded.shot.cameras[0].name, "shot3");
  const render::CameraPtr wanted = camera_of(shot.candidate.pose);
  for (const Vec2f& film : {Vec2f(0.5f, 0.5f), Vec2f(0, 0), Vec2f(1, 0.3f)}) {
    const render::Ray a = loaded.shot.cameras[0].camera->ray(film, 1.6f, {0.5f, 0.5f});
    const render::Ray b = wanted->ray(film, 1.6f, {0.5f, 0.5f});
    EXPECT_EQ(a.origin, b.origin);
    EXPECT_LT(render::length(a.direction - b.direction), 1e-5f);
  }
}

TEST(ShotText, AzimuthsCompareAcrossTheFullTurn) {
  EXPECT_NEAR(azimuth_between(0.1, 2 * kPi - 0.1), 0.2, 1e-12);
  EXPECT_NEAR(azimuth_between(-3, 3), 2 * kPi - 6, 1e-12);
  EXPECT_NEAR(azimuth_between(0, kPi), kPi, 1e-12);
}

TEST(ShotText, TheSheetShowsEachPictureAtItsPlace) {
  std::vector<image::Image> pictures;
  for (int i = 0; i < 6; ++i) {
    pictures.emplace_back(32, 24, std::vector<std::string>{"R", "G", "B"});
    for (float& value : pictures.back().pixels) value = 0.1f * static_cast<float>(i + 1);
  }
  const image::Image sheet = contact_sheet(pictures);
  EXPECT_EQ(sheet.width, 4 * 36 + 4);
  EXPECT_EQ(sheet.height, 2 * 28 + 4);
  for (int i = 0; i < 6; ++i) {
    const double shown = static_cast<double>(sheet.at(4 + i % 4 * 36 + 31, 4 + i / 4 * 28 + 23, 1));
    const double v = 0.1 * (i + 1);
    EXPECT_NEAR(shown, v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4), 1e-6);
  }
  EXPECT_EQ(sheet.at(1, 1, 0), 0) << "the margin";
  // "1" is white on black: its foot is a row of three dots, and its left upper dot is black.
  EXPECT_EQ(sheet.at(4 + 3, 4 + 15, 0), 1);
  EXPECT_EQ(sheet.at(4 + 3, 4 + 3, 0), 0);
}

}  // namespace
}  // namespace vug::scout
