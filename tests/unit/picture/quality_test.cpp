// SPDX-License-Identifier: Apache-2.0
// The quality of a picture sets samples, noise and denoising, unless they have values of their own.
#include <gtest/gtest.h>
#include <vug/loading/load.h>
#include <vug/picture/picture_plan.h>

namespace vug::picture {
namespace {

using shot::Quality;

/// The settings of a picture with the entries of its block, and with options.
shot::RenderSettings planned(const std::string& entries, const NamedValues& options = {}) {
  const loading::Loaded loaded =
      loading::load_text("render main { size 20x10 " + entries + " }\n", "t.vug");
  EXPECT_EQ(loaded.report(), "");
  PictureOptions picture;
  picture.settings = options;
  return plan_picture(loaded.shot, picture).render.settings;
}

void expect(const shot::RenderSettings& settings, int spp, double noise, bool denoise) {
  EXPECT_EQ(settings.spp, spp);
  EXPECT_EQ(settings.noise, noise);
  EXPECT_EQ(settings.denoise, denoise);
}

void expect(const shot::RenderSettings& settings, Quality quality) {
  const shot::QualityTargets targets = quality_targets(quality);
  EXPECT_EQ(settings.quality, quality);
  expect(settings, targets.spp, targets.noise, targets.denoise);
}

NamedValues quality(const char* name) { return {{"quality", Value::Name{name}}}; }

TEST(Quality, IncreasesFromDraftToFinal) {
  const auto draft = quality_targets(Quality::draft), look = quality_targets(Quality::look),
             final = quality_targets(Quality::final);
  EXPECT_LT(draft.spp, look.spp);
  EXPECT_LT(look.spp, final.spp);
  EXPECT_GT(look.noise, final.noise);
  EXPECT_GT(final.noise, 0);
  EXPECT_FALSE(final.denoise);  // a denoiser smears
}

TEST(Quality, IsLookForPicturesThatStateNoSamples) {
  expect(planned(""), Quality::look);
  expect(planned("denoise false"), 128, 0.08, false);
  expect(plan_picture(loading::load_text("", "t.vug").shot).render.settings, Quality::look);
}

TEST(Quality, DoesNotTouchStatedSamplesAndNoise) {
  expect(planned("spp 7"), 7, 0, false);
  expect(planned("spp 64"), 64, 0, false);  // the former default, but stated
  expect(planned("spp 7  denoise true"), 7, 0, true);
  expect(planned("noise 3%"), shot::RenderSettings().spp, 0.03, false);
  expect(planned("", {{"spp", 7}}), 7, 0, false);
  expect(planned("", {{"noise", 0.01}}), shot::RenderSettings().spp, 0.01, false);
}

TEST(Quality, OfTheSceneFillsWhatTheBlockOmits) {
  expect(planned("quality final"), Quality::final);
  expect(planned("quality look  noise 5%"), 128, 0.05, true);
  expect(planned("quality look  spp 40"), 40, 0, true);  // exactly 40
  expect(planned("quality look  spp 40  noise 5%  denoise false"), 40, 0.05, false);
}

TEST(Quality, OfAnOptionReplacesTheValuesOfTheScene) {
  expect(planned("spp 7  noise 1%  denoise true", quality("final")), Quality::final);
  expect(planned("quality final", quality("draft")), Quality::draft);
  NamedValues options = quality("look");
  options.emplace_back("spp", 16);
  expect(planned("noise 1%  denoise false", options), 16, 0, true);
  options.emplace_back("noise", 0.05);
  expect(planned("noise 1%", options), 16, 0.05, true);
}

TEST(Quality, OptionsReplaceThoseOfTheQualityOfTheScene) {
  expect(planned("quality look", {{"spp", 16}}), 16, 0, true);
  expect(planned("quality look  spp 40", {{"noise", 0.02}}), 40, 0.02, true);
  expect(planned("quality look", {{"denoise", false}}), 128, 0.08, false);
}

}  // namespace
}  // namespace vug::picture
