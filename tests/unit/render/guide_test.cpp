// The guide: its densities are densities, and it finds again what it was told.
#include "chi2.h"

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/render/guiding/guide.h>

namespace vug::render {
namespace {

Vec2f pair(uint64_t i, uint64_t salt) {
  RandomStream stream{RandomKey(salt).at(i)};
  return {static_cast<float>(stream.uniform()), static_cast<float>(stream.uniform())};
}

/// A guide that saw light from a narrow cone around `axis`, and some from everywhere.
Guide taught(const Vec3f& axis, int rounds) {
  Guide guide(Box3f(Vec3f(-1.0f), Vec3f(1.0f)));
  const Frame frame(axis);
  for (int round = 0; round < rounds; ++round) {
    GuideTraining training(guide);
    parallel_for(20000, [&](size_t i) {
      const Vec2f u = pair(i, 1 + static_cast<uint64_t>(round)), v = pair(i, 100);
      const Vec3f point(2 * v.x - 1, 2 * v.y - 1, 0.3f);
      const Vec3f direction =
          i % 4 ? frame.to_world(direction_off_axis(0.01f * u.x, u.y)) : sample_sphere(u);
      training.record(point, direction, 1);
    });
    guide = training.finish();
  }
  return guide;
}

TEST(Guide, TurnsAreAngles) {
  for (int i = 0; i < 1000; ++i) {
    const double turn = i / 1000.0;
    const SinCos sc = sincos_turns(static_cast<float>(turn));
    const double off = static_cast<double>(turns_of(sc.sin, sc.cos)) - turn;
    EXPECT_LT(std::fabs(off - std::round(off)), 2e-7) << turn;
  }
}

TEST(Guide, SamplesFollowItsDensity) {
  const Vec3f axis = normalized(Vec3f(0.3f, 0.9f, -0.4f));
  const Guide guide = taught(axis, 4);
  const DirectionTree* tree = guide.at({0.2f, 0.1f, 0.3f});
  ASSERT_NE(tree, nullptr);
  const Chi2 result = chi2(
      axis, 2, 400000,
      [&](int s) {
        const Vec3f d = tree->sample(pair(static_cast<uint64_t>(s), 7));
        return DirectionSample{d, static_cast<double>(tree->pdf(d))};
      },
      [&](const Vec3f& d) { return static_cast<double>(tree->pdf(d)); });
  EXPECT_GT(result.p, 0.01);
  EXPECT_NEAR(result.integral, 1, 2e-3);
  // Three quarters of the light came from the cone, which has 1/200 of the sphere.
  double inside = 0;
  constexpr int kProbes = 1000;
  for (int i = 0; i < kProbes; ++i) {
    const Vec2f u = pair(static_cast<uint64_t>(i), 8);
    inside +=
        static_cast<double>(tree->pdf(Frame(axis).to_world(direction_off_axis(0.01f * u.x, u.y)))) /
        kProbes;
  }
  EXPECT_GT(inside * 0.01 * 2 * kPi, 0.6);
}

}  // namespace
}  // namespace vug::render
