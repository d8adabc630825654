// SPDX-License-Identifier: Apache-2.0
// The exposures auto, locked and physical.
#include <gtest/gtest.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/picture/exposure.h>

#include <cmath>

namespace vug::picture {
namespace {

using Mode = shot::Exposure::Mode;

/// A grey picture with pixels of the luminances.
image::Image picture_of(const std::vector<float>& luminances) {
  image::Image out(static_cast<int>(luminances.size()), 1, {"R", "G", "B"});
  for (size_t i = 0; i < luminances.size(); ++i)
    for (size_t c = 0; c < 3; ++c) out.pixels[3 * i + c] = luminances[i];
  return out;
}

shot::OutputSettings settings_of(Mode mode, double stops = 0) {
  shot::OutputSettings settings;
  settings.exposure = {mode, stops};
  return settings;
}

TEST(Exposure, ANumberOfStopsIsNotChanged) {
  EXPECT_EQ(exposure_stops(settings_of(Mode::stops, 2.3456), picture_of({1})), 2.3456);
}

TEST(Exposure, AutoIsMeteredAndCompensated) {
  shot::OutputSettings settings = settings_of(Mode::automatic);
  const image::Image grey = picture_of(std::vector<float>(100, 0.16f));
  EXPECT_EQ(exposure_stops(settings, grey), 0);
  EXPECT_EQ(exposure_stops(settings, picture_of(std::vector<float>(100, 0.01f))), 4);
  settings.compensation = -1.5;
  EXPECT_EQ(exposure_stops(settings, grey), -1.5);
  EXPECT_EQ(exposure_stops(settings_of(Mode::automatic), picture_of({0, 0, 0})), 0);
}

TEST(Exposure, PhysicalCamerasFollowTheirTriangle) {
  shot::OutputSettings settings = settings_of(Mode::physical);
  settings.iso = 100, settings.f_number = 1, settings.exposure_time = 1;
  const double base = exposure_stops(settings, {});
  EXPECT_NEAR(base, std::log2(179 / 1.2), 0.005);  // EV100 0
  settings.iso = 800;
  EXPECT_DOUBLE_EQ(exposure_stops(settings, {}), base + 3);
  settings.f_number = 4;
  EXPECT_DOUBLE_EQ(exposure_stops(settings, {}), base - 1);
  settings.exposure_time = 0.125;
  EXPECT_DOUBLE_EQ(exposure_stops(settings, {}), base - 4);
}

TEST(Exposure, LockedIsThatOfTheFirstPictureOfItsBlock) {
  const image::Image dim = picture_of(std::vector<float>(100, 0.01f)),
                     bright = picture_of(std::vector<float>(100, 0.64f));
  ExposureLock lock;
  const auto locked = [&](const std::string& render, const image::Image& picture) {
    shot::OutputSettings settings = settings_of(Mode::locked);
    lock.apply(render, picture, settings);
    EXPECT_EQ(settings.exposure.mode, Mode::stops);
    return settings.exposure.stops;
  };
  EXPECT_EQ(locked("main", dim), 4);
  EXPECT_EQ(locked("main", bright), 4);
  EXPECT_EQ(locked("plan", bright), -2);
  shot::OutputSettings automatic = settings_of(Mode::automatic);
  lock.apply("main", bright, automatic);
  EXPECT_EQ(automatic.exposure.mode, Mode::automatic);
}

TEST(Exposure, ALockContinuesFromAFinishedPicture) {
  const ScratchFolder folder("vug_exposure");
  image::ExrOptions options;
  options.metadata = {{kExposure, "3.25"}};
  const auto exr = folder.file("first.exr");
  image::write_exr(exr, {{"", picture_of({1}), options}});
  ExposureLock lock;
  lock.take("main", exr);
  shot::OutputSettings settings = settings_of(Mode::locked);
  lock.apply("main", picture_of({1}), settings);
  EXPECT_EQ(settings.exposure.stops, 3.25);
}

}  // namespace
}  // namespace vug::picture
