// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/image/diff.h>
#include <vug/image/views.h>

#include <gtest/gtest.h>

#include <functional>
#include <limits>

namespace vug::image {
namespace {

/// An image with layers and noise of known deviation.
ImageUnderTest subject(uint64_t seed, bool variance, double gain = 1) {
  ImageUnderTest out;
  out.name = "picture " + std::to_string(seed);
  std::vector<std::string> channels = {"R", "G", "B", "Z", "albedo.R", "albedo.G", "albedo.B"};
  if (variance) channels.insert(channels.end(), {"variance.R", "variance.G", "variance.B"});
  out.image = Image(64, 48, channels);
  RandomStream random(RandomKey(seed).at("diff"));
  for (int y = 0; y < 48; ++y)
    for (int x = 0; x < 64; ++x) {
      for (size_t c = 0; c < 3; ++c)
        out.image.at(x, y, c) = static_cast<float>(gain * (1 + 0.05 * random.normal()));
      out.image.at(x, y, 3) = static_cast<float>(2 + x);
      for (size_t c = 4; c < 7; ++c) out.image.at(x, y, c) = 0.5f;
      for (size_t c = 7; c < channels.size(); ++c) out.image.at(x, y, c) = 0.0025f;
    }
  return out;
}

double value_of(const Diff& diff, const std::string& layer, const std::string& measure) {
  for (const LayerResult& row : diff.rows)
    if (row.layer == layer && row.measure == measure) return row.value;
  ADD_FAILURE() << "no row " << layer << " " << measure;
  return -1;
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_FALSE(error.hint().empty()) << error.what();
    return error.what();
  }
  return "nothing was thrown";
}

TEST(Diff, EqualPicturesAreIdentical) {
  const Diff found = diff(subject(1, true), subject(1, true));
  EXPECT_TRUE(found.same);
  EXPECT_EQ(found.basis, Basis::identical);
  for (const LayerResult& row : found.rows)
    EXPECT_EQ(row.value, measure_of(row.measure).equal) << row.layer << " " << row.measure;
  EXPECT_TRUE(found.unjudged.empty());
}

TEST(Diff, NoiseAloneIsTheSameAndOnePercentIsNot) {
  const Diff noise = diff(subject(1, true), subject(2, true));
  EXPECT_TRUE(noise.same);
  EXPECT_EQ(noise.basis, Basis::significance);
  const Diff darker = diff(subject(1, true), subject(2, true, 0.99));
  EXPECT_FALSE(darker.same);
  EXPECT_FALSE(darker.reasons.empty());
}

TEST(Diff, WithoutVarianceOnlyRoundingIsAllowed) {
  const ImageUnderTest a = subject(1, false);
  EXPECT_FALSE(diff(a, subject(2, false)).same);
  ImageUnderTest rounded = a;
  for (float& v : rounded.image.pixels) v *= 1 + 4e-4f;
  const Diff found = diff(a, rounded);
  EXPECT_TRUE(found.same);
  EXPECT_EQ(found.basis, Basis::rounding);
  ImageUnderTest other = a;
  other.image.at(3, 3, 3) *= 1.01f;  // One value of Z.
  const Diff depth = diff(a, other);
  EXPECT_FALSE(depth.same);
  EXPECT_EQ(diff(other, a).same, depth.same);
}

TEST(Diff, LimitsDecideIfGiven) {
  const ImageUnderTest a = subject(1, true), b = subject(2, true, 0.9);
  DiffOptions options;
  options.limits = {limit_of("relative_rmse", 0.2), limit_of("ssim", 0)};
  EXPECT_TRUE(diff(a, b, options).same);
  options.limits = {limit_of("beauty.rmse", 0.01)};
  EXPECT_FALSE(diff(a, b, options).same);
  options.limits = {limit_of("psnr", 90)};
  EXPECT_FALSE(diff(a, b, options).same);
  options.limits = {limit_of("relative_rmse", 0.2)};
  options.false_alarm_rate = 0.01;
  EXPECT_FALSE(diff(a, b, options).same) << "the test of significance was demanded too";
}

TEST(Diff, UnjudgedLayersAreNamed) {
  const ImageUnderTest a = subject(1, true);
  ImageUnderTest b = subject(2, true);
  b.image.at(3, 3, 3) = 7;
  const Diff found = diff(a, b);
  EXPECT_TRUE(found.same);
  EXPECT_EQ(found.unjudged, std::vector<std::string>{"Z"});
  DiffOptions options;
  options.limits = {limit_of("Z.max", 0.5)};
  const Diff limited = diff(a, b, options);
  EXPECT_FALSE(limited.same);
  EXPECT_EQ(limited.reasons.size(), 1u);
  EXPECT_TRUE(limited.tested) << "the beauty has no limit, so its noise decides";
  EXPECT_TRUE(limited.unjudged.empty());
}

TEST(Diff, ChosenLayersAreTheMainOnes) {
  DiffOptions options;
  options.layers = {"albedo"};
  options.limits = {limit_of("mean", 0.1)};
  ImageUnderTest b = subject(1, false);
  for (int x = 0; x < 64; ++x)
    for (int y = 0; y < 48; ++y) b.image.at(x, y, 5) = 0.8f;
  const Diff found = diff(subject(1, false), b, options);
  EXPECT_NEAR(value_of(found, "albedo", "mean"), 0.1, 1e-7);
  EXPECT_GT(value_of(found, "albedo", "flip"), 0.05);
  EXPECT_EQ(found.shown_layer, "albedo");
}

TEST(Diff, MaskedDifferencesDoNotCount) {
  const ImageUnderTest a = subject(1, true);
  ImageUnderTest b = a;
  b.image.at(5, 5, 0) = 100;
  DiffOptions options;
  EXPECT_FALSE(diff(a, b, options).same);
  options.mask.assign(a.image.pixel_count(), 1);
  options.mask[5 * 64 + 5] = 0;
  EXPECT_TRUE(diff(a, b, options).same);
}

TEST(Diff, OneValueThatIsNotFiniteIsADifference) {
  const ImageUnderTest a = subject(1, true);
  ImageUnderTest b = subject(2, true);
  b.image.at(5, 5, 0) = std::numeric_limits<float>::quiet_NaN();
  const Diff found = diff(a, b);
  EXPECT_FALSE(found.same);
  EXPECT_EQ(found.not_finite, 1u);
}

TEST(Diff, RefusalsAreSentencesWithHints) {
  const ImageUnderTest a = subject(1, true);
  ImageUnderTest small = a, bare = a;
  small.image = Image(2, 2, a.image.channels);
  bare.image = a.image.select({"R", "G", "B"});
  EXPECT_NE(refusal([&] { diff(a, small); }).find("2 x 2"), std::string::npos);
  EXPECT_NE(refusal([&] { diff(a, bare); }).find("no channel Z"), std::string::npos);
  EXPECT_NE(refusal([&] { diff(bare, a); }).find("no channel Z"), std::string::npos);
  ImageUnderTest moved = a;
  moved.left = 3;
  EXPECT_NE(refusal([&] { diff(a, moved); }).find("crop from 3, 0"), std::string::npos);
  DiffOptions options;
  options.layers = {"albeda"};
  EXPECT_NE(refusal([&] { diff(a, a, options); }).find("albeda"), std::string::npos);
  options.layers = {"beauty"};
  EXPECT_TRUE(diff(a, bare, options).same);
  options.limits = {limit_of("Z.max", 1)};
  EXPECT_NE(refusal([&] { diff(a, a, options); }).find("'Z'"), std::string::npos);
  EXPECT_NE(refusal([&] { limit_of("beauty.rsme", 1); }).find("rsme"), std::string::npos);
  options.limits.clear();
  options.false_alarm_rate = 0.01;
  EXPECT_NE(refusal([&] { diff(bare, bare, options); }).find("variance"), std::string::npos);
}

/// Both views of a stereo image, the right one with its own gain.
ImageUnderTest stereo(uint64_t seed, bool variance, double right_gain = 1) {
  ImageUnderTest out = subject(seed, variance);
  const ImageUnderTest right = subject(seed + 100, variance, right_gain);
  out.image = stereo_image(out.image, right.image);
  return out;
}

TEST(Diff, ViewsOfAStereoImageAreItsParts) {
  const Image left = subject(1, true).image, right = subject(2, true).image;
  const Image both = stereo_image(left, right);
  const std::vector<View> views = views_of(both.channels);
  ASSERT_EQ(views.size(), 2u);
  EXPECT_EQ(views[1].name, "right");
  for (const auto& [view, one] : {std::pair(views[0], left), {views[1], right}}) {
    EXPECT_EQ(view.channels, one.channels);
    EXPECT_EQ(extract(both, view).pixels, one.pixels);
  }
}

TEST(Diff, BothViewsOfAStereoImageAreJudged) {
  const Diff noise = diff(stereo(1, true), stereo(2, true));
  EXPECT_TRUE(noise.same);
  ASSERT_EQ(noise.other_views.size(), 1u);
  EXPECT_EQ(noise.other_views[0].first, "right");
  EXPECT_GE(value_of(noise, "right", "rmse"), 0.05);
  const Diff darker = diff(stereo(1, true), stereo(2, true, 0.98));
  EXPECT_FALSE(darker.same);
  for (const std::string& reason : darker.reasons) EXPECT_EQ(reason.rfind("right: ", 0), 0u);
  EXPECT_FALSE(darker.significance->different);
  EXPECT_TRUE(darker.other_views[0].second.different);

  // Without variance: by rounding; a limit applies to both views, or to the one it names.
  EXPECT_FALSE(diff(stereo(1, false), stereo(1, false, 0.98)).same);
  DiffOptions options;
  options.limits = {limit_of("max", 1e-9)};
  EXPECT_FALSE(diff(stereo(1, false), stereo(1, false, 0.98), options).same);
  options.limits = {limit_of("left.max", 1e-9), limit_of("right.max", 0.5)};
  EXPECT_TRUE(diff(stereo(1, false), stereo(1, false, 0.98), options).same);
  options.limits = {limit_of("right.max", 1e-9)};
  EXPECT_FALSE(diff(stereo(1, false), stereo(1, false, 0.98), options).same);
  options = {};
  options.layers = {"left", "right.albedo"};
  EXPECT_TRUE(diff(stereo(1, false), stereo(1, false, 0.98), options).same);
  options.layers = {"right"};
  EXPECT_FALSE(diff(stereo(1, false), stereo(1, false, 0.98), options).same);
  EXPECT_EQ(diff(stereo(3, true), stereo(3, true)).basis, Basis::identical);
  EXPECT_NE(refusal([] { diff(stereo(1, true), subject(1, true)); }).find("stereo image"),
            std::string::npos);
}

TEST(Diff, ViewsShareTheFalseAlarmRate) {
  int alarms = 0;
  DiffOptions options;
  options.false_alarm_rate = 0.1;
  for (uint64_t seed = 0; seed < 100; ++seed)
    if (!diff(stereo(1000 + seed, true), stereo(2000 + seed, true), options).same) ++alarms;
  EXPECT_LE(alarms, 20) << "10 are expected at most";
}

}  // namespace
}  // namespace vug::image
