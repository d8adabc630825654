// SPDX-License-Identifier: Apache-2.0
// Blends: compact support, depth, slope, and the shapes of the profiles.
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

Blend make_blend(const BlendKind& kind, double radius) {
  Arguments arguments;
  if (!kind.info.params.empty()) arguments.push_back({"radius", radius, {}});
  Diagnostics diagnostics;
  return kind.make(arguments, {}, diagnostics).value();
}

TEST(Blend, EveryKindHasCompactSupportAndLiesBetweenMinAndDepth) {
  ASSERT_EQ(blends().size(), 4u);
  for (const BlendKind* kind : blends()) {
    const Blend blend = make_blend(*kind, 0.3);
    RandomStream random(RandomKey(5));
    for (int i = 0; i < 10000; ++i) {
      const double a = random.uniform(-1, 1), b = random.uniform(-1, 1);
      const double least = std::min(a, b), value = blend.smin(a, b);
      if (std::fabs(a - b) >= 0.3) {
        EXPECT_EQ(value, least) << kind->info.name;
      }
      EXPECT_LE(value, least);
      EXPECT_GE(value, least - blend.depth() - 1e-15);
      EXPECT_EQ(value, blend.smin(b, a));
      // Both weights are in [0, 1]: a step of each operand changes the value by at most the larger
      // step.
      const double da = random.uniform(-0.1, 0.1), db = random.uniform(-0.1, 0.1);
      EXPECT_LE(std::fabs(blend.smin(a + da, b + db) - value),
                std::max(std::fabs(da), std::fabs(db)) + 1e-15);
    }
  }
}

/// Two walls at a right angle, x < 0 and y < 0, as fields.
TEST(Blend, RoundFilletHasItsRadiusAndChamferItsLegs) {
  const Blend round{Profile::round, 1}, chamfer{Profile::chamfer, 1};
  for (double angle = 0.02; angle < kPi / 2; angle += 0.1) {
    // The fillet of a re-entrant corner: an arc about (1, 1), tangent to both walls.
    const double x = 1 - std::cos(angle), y = 1 - std::sin(angle);
    EXPECT_NEAR(round.smin(x, y), 0, 1e-12) << angle;
  }
  for (double x = 0; x <= 1; x += 0.125) EXPECT_NEAR(chamfer.smin(x, 1 - x), 0, 1e-15);
}

TEST(Blend, OffsetAndShellOfABallAreBalls) {
  const Field ball = make("sphere", {{"radius", 2.0}});
  const Field grown = make("offset", {{"field", as_value(ball)}, {"by", 0.5}});
  const Field shell = make("shell", {{"field", as_value(ball)}, {"thickness", 0.5}});
  EXPECT_NEAR(grown.value({0, 2.5, 0}), 0, 1e-15);
  EXPECT_EQ(grown.bounds().max, Vec3d(2.5));
  EXPECT_NEAR(shell.value({2.25, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(shell.value({1.75, 0, 0}), 0, 1e-15);
  EXPECT_NEAR(shell.value({0, 0, 2}), -0.25, 1e-15);
}

TEST(Blend, BoundsHoldTheBulge) {
  const Field ball = make("sphere");
  for (const BlendKind* kind : blends()) {
    const Blend blend = make_blend(*kind, 0.8);
    const Field pair = unite({ball, transformed(ball, Transform::translation({0.3, 0, 0}))}, blend);
    double top = 0;
    for (double y = 1; y < 2; y += 1e-3)
      if (pair.value({0.15, y, 0}) <= 0) top = y;
    EXPECT_LE(top, pair.bounds().max.y);
    if (kind->info.name != "sharp") {
      EXPECT_GT(top, 1.0);
    }
  }
}

}  // namespace
}  // namespace vug::field
