// SPDX-License-Identifier: Apache-2.0
#include "chi2.h"
#include "uniform.h"

#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/image/io.h>
#include <vug/render/kinds.h>

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

namespace vug::render {
namespace {

constexpr int kSamples = 200000;

/// Significance level of one of `tests` tests such that all of them together fail by chance in 1 of
/// 100 cases (Sidak).
double chi2_level(int tests) { return 1 - std::pow(0.99, 1.0 / tests); }

/// A sky picture with a bright spot and a gradient, for lights that require a file.
std::string sky_file() {
  static const std::string path = [] {
    image::Image sky(32, 16, {"R", "G", "B"});
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 32; ++x)
        for (size_t c = 0; c < 3; ++c)
          sky.at(x, y, c) = x == 20 && y == 5 ? 30.0f : 0.02f * static_cast<float>(16 - y);
    static const ScratchFolder scratch("vug_sky");
    const auto file = scratch.file("sky.exr");
    image::write_exr(file, sky);
    return file.string();
  }();
  return path;
}

/// The required arguments of any kind.
NamedValues required_parameters(const KindInfo& info) {
  NamedValues out;
  for (const ParamInfo& p : info.params)
    if (p.required && p.name == "file")
      out.emplace_back("file",
                       info.name == "ies" ? VUG_TEST_DATA "/lights/cosine.ies" : sky_file());
  return out;
}

TEST(ChiSquare, TailMatchesTables) {  // Abramowitz and Stegun, table 26.8
  EXPECT_NEAR(chi2_tail(18.307, 10), 0.05, 1e-3);
  EXPECT_NEAR(chi2_tail(124.342, 100), 0.05, 1e-3);
  EXPECT_NEAR(chi2_tail(135.807, 100), 0.01, 5e-4);
}

TEST(ChiSquare, EveryLightSamplesItsDensity) {
  // Near, far, grazing and at an angle; the default lights emit downwards from the origin.
  const Vec3f points[] = {{0.1f, -0.3f, 0.2f}, {3, -0.2f, 1}, {1, -2, -1}, {4, -20, 9}};
  const int tests = static_cast<int>(lights().size()) * 4;
  for (const auto* kind : lights())
    for (const Vec3f& position : points) {
      SCOPED_TRACE(kind->info.name + " from x = " + std::to_string(position.x));
      NamedValues given = required_parameters(kind->info);
      // Narrow cones are made wide enough for the test's cells.
      for (const ParamInfo& p : kind->info.params)
        if (p.name == "angle") given.emplace_back("angle", radians(0.9));
      const LightPtr light = make_light(kind->info.name, given);
      const LightSampleContext point{position, Vec3f(0.0f)};
      RandomStream random(RandomKey(8).at(kind->info.name));
      if (!(light->importance(point) > 0)) {
        EXPECT_FALSE(light->sample(point, {0.3f, 0.6f}).pdf > 0) << "never chosen, yet samples";
        continue;
      }
      const bool all_round = light->is_infinite() && !light->is_portal();
      const Vec3f axis = all_round ? Vec3f(0, 1, 0) : normalized(light->center() - position);
      double sine = 0;  // of the widest angle; only lights within a hemisphere get here
      for (int i = 0; i < 10000 && !all_round; ++i)
        sine = std::max(sine, static_cast<double>(length(cross(
                                  axis, light->sample(point, uniform_2d(random)).direction))));
      const double cap = all_round ? 2 : 1.1 * (sine * sine / (1 + std::sqrt(1 - sine * sine)));
      const Chi2 result = chi2(
          axis, cap, kSamples,
          [&](int) -> DirectionSample {
            const LightSample s = light->sample(point, uniform_2d(random));
            EXPECT_NEAR(length(s.direction), 1, 1e-5);
            return {s.direction, static_cast<double>(s.pdf)};
          },
          [&](const Vec3f& d) { return static_cast<double>(light->pdf(point, d)); });
      EXPECT_GT(result.p, chi2_level(tests));
      EXPECT_NEAR(result.integral, 1, 4e-3);
      EXPECT_LT(result.stray, kSamples / 10000);
      EXPECT_LT(result.disagreements, kSamples / 2000);  // edges, by rounding
    }
}

TEST(ChiSquare, EveryPhaseFunctionSamplesItsDensity) {
  for (const auto* kind : media())
    for (const double g : {-0.5, 0.0, 0.6, 0.9}) {
      SCOPED_TRACE(kind->info.name + " g = " + std::to_string(g));
      const MediumPtr medium = make_medium(kind->info.name, {{"g", g}});
      const Vec3f travel = normalized(Vec3f(1, 2, -0.5f));
      RandomStream random(RandomKey(9).at(kind->info.name));
      double mean_cosine = 0;
      const Chi2 result = chi2(
          travel, 2, kSamples,
          [&](int) -> DirectionSample {
            const Vec3f d = medium->sample_phase(travel, uniform_2d(random));
            mean_cosine += static_cast<double>(dot(d, travel)) / kSamples;
            return {d, static_cast<double>(medium->phase(dot(d, travel)))};
          },
          [&](const Vec3f& d) { return static_cast<double>(medium->phase(dot(d, travel))); });
      EXPECT_GT(result.p, chi2_level(static_cast<int>(media().size()) * 4));
      EXPECT_NEAR(result.integral, 1, 2e-3);
      EXPECT_NEAR(mean_cosine, g, 4 / std::sqrt(3.0 * kSamples));
      EXPECT_LT(result.disagreements, kSamples / 10000);
    }
}

TEST(ChiSquare, DistancesAreExponential) {
  for (const auto* kind : media()) {
    const MediumPtr medium = make_medium(kind->info.name, {{"extinction", 0.7}});
    if (medium->needs_density()) continue;  // its density is tested in cloud_test.cpp
    TrackingRng numbers(Vec2f(0.1f, 0.2f));
    const Ray ray{{0, 0, 0}, {0, 0, 1}};
    const Segment segment{1, 4};
    RandomStream random(RandomKey(10));
    int through = 0;
    double sum = 0;
    for (int i = 0; i < kSamples; ++i) {
      const DistanceSample s = medium->sample_distance(ray, segment, uniform_2d(random).x, numbers);
      if (!s.scattered) {
        ++through;
        continue;
      }
      ASSERT_GE(s.distance, 1);
      ASSERT_LE(s.distance, 4);
      sum += static_cast<double>(s.distance);
    }
    const double clear = std::exp(-2.1);
    EXPECT_NEAR(medium->transmittance(ray, segment, numbers), clear, 1e-6);
    EXPECT_NEAR(static_cast<double>(through) / kSamples, clear,
                4 * std::sqrt(clear * (1 - clear) / kSamples));
    const double mean = 1 + 1 / 0.7 - 3 * clear / (1 - clear);
    EXPECT_NEAR(sum / (kSamples - through), mean, 4.0 / std::sqrt(kSamples));
  }
}

}  // namespace
}  // namespace vug::render
