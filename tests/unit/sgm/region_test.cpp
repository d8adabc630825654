// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/sgm/region.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::sgm {
namespace {

Vec3d somewhere(RandomStream& random) {
  return {random.uniform(-3, 5), random.uniform(-3, 3), random.uniform(-3, 3)};
}

/// Both local fields, sharp and blended, on overlapping solids.
std::vector<Field> samples() {
  const Field base = field::unite({ball(1), moved(box({1, 0.6, 0.7}), {1, 0.2, 0})});
  const Field shape = moved(torus(0.8, 0.4), {2, 0.1, 0});
  std::vector<Field> out;
  for (const auto profile : {field::Profile::sharp, field::Profile::smooth, field::Profile::round,
                             field::Profile::chamfer}) {
    const field::Blend blend{profile, 0.3};
    out.push_back(local_morph(base, shape, 0.52, blend));
    out.push_back(local_intersection(base, shape, {2, 0.1, 0}, {1, 0, 0}, 1.5, blend));
  }
  return out;
}

TEST(LocalMorph, IsTheMorphWhereTheShapeIsNearerAndTheBaseElsewhere) {
  const Field base = ball(1), shape = moved(ball(1), {1, 0, 0});
  const Field local = local_morph(base, shape, 0.52), whole = field::morph(base, shape, 0.52);
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 10000; ++i) {
    const Vec3d p = somewhere(random);
    if (shape.value(p) < base.value(p))
      ASSERT_NEAR(local.value(p), whole.value(p), 1e-14);
    else
      ASSERT_EQ(local.value(p), base.value(p));
  }
}

TEST(LocalMorph, EndsAreTheBaseAndTheUnionBitForBit) {
  const Field base = ball(1), shape = moved(ball(1), {1, 0, 0});
  const Field zero = local_morph(base, shape, 0), one = local_morph(base, shape, 1);
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 10000; ++i) {
    const Vec3d p = somewhere(random);
    ASSERT_EQ(zero.value(p), base.value(p));
    ASSERT_EQ(one.value(p), std::min(base.value(p), shape.value(p)));
  }
  EXPECT_THROW(local_morph(base, shape, 1.5), Error);
}

TEST(LocalMorph, NestsWithoutDoublingTheWork) {
  Field f = ball(1);
  for (int i = 1; i <= 200; ++i) f = local_morph(f, moved(ball(1), {0.5 * i, 0, 0}), 0.5);
  EXPECT_LT(f.value({0, 0, 0}),
            0);  // Would take 2^200 evaluations if the base was evaluated twice.
}

TEST(LocalIntersection, PreservesTheBaseBehindThePlane) {
  const Field base = box({5, 1, 1}), shape = moved(ball(1.5), {4, 0, 0});
  const Field f = local_intersection(base, shape, {4, 0, 0}, {1, 0, 0}, 3);
  EXPECT_LT(f.value({-4.9, 0.9, 0.9}), 0);
  EXPECT_LT(f.value({3.9, 0.9, 0.9}), 0);    // Behind the plane.
  EXPECT_GT(f.value({4.9, 0.95, 0.95}), 0);  // Beyond it and outside the ball.
  EXPECT_NEAR(f.value({5, 0, 0}), 0, 1e-12);
}

TEST(LocalFields, RestrictionsPreserveAndBoundValues) {
  RandomStream random(RandomKey(3));
  for (const Field& f : samples())
    for (int i = 0; i < 200; ++i) {
      const field::Ball region{somewhere(random), random.uniform(0.05, 1)};
      const Field::RestrictedField part = f.restricted(region);
      for (int k = 0; k < 20; ++k) {
        const Vec3d p = region.centre +
                        Vec3d(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)) *
                            (0.57 * region.radius);
        ASSERT_EQ(part.field.value(p), f.value(p));
        ASSERT_GE(f.value(p), part.range.lo - 1e-12);
        ASSERT_LE(f.value(p), part.range.hi + 1e-12);
      }
    }
}

TEST(LocalFields, IntervalsHoldSamples) {
  RandomStream random(RandomKey(4));
  for (const Field& f : samples())
    for (int i = 0; i < 200; ++i) {
      const Vec3d a = somewhere(random), b = a + (somewhere(random) - a) * random.uniform();
      Box3d box;
      box.extendBy(a);
      box.extendBy(b);
      const Interval range = f.interval(box);
      for (int k = 0; k < 20; ++k) {
        const Vec3d p(random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y),
                      random.uniform(box.min.z, box.max.z));
        ASSERT_GE(f.value(p), range.lo - 1e-9);
        ASSERT_LE(f.value(p), range.hi + 1e-9);
      }
    }
}

TEST(LocalFields, GradientsMatchDifferencesAndTheLipschitzConstant) {
  RandomStream random(RandomKey(5));
  for (const Field& f : samples()) {
    int bad = 0;  // At creases the one-sided gradient and the difference disagree.
    for (int i = 0; i < 1000; ++i) {
      const Vec3d p = somewhere(random), q = somewhere(random);
      ASSERT_LE(std::fabs(f.value(p) - f.value(q)), f.lipschitz() * (p - q).length() + 1e-12);
      const Vec3d g = f.gradient(p).gradient;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3d h(0);
        h[axis] = 1e-6;
        bad += std::fabs((f.value(p + h) - f.value(p - h)) / 2e-6 - g[axis]) > 1e-5;
      }
    }
    EXPECT_LT(bad, 10);
  }
}

TEST(LocalFields, BoundsContainTheInside) {
  RandomStream random(RandomKey(6));
  for (const Field& f : samples())
    for (int i = 0; i < 5000; ++i) {
      const Vec3d p = somewhere(random);
      ASSERT_TRUE(f.value(p) > 0 || f.bounds().intersects(p));
    }
}

// Required by offsets, displacement and further blends to stay finite.
TEST(LocalFields, GrowAwayFromTheirBounds) {
  RandomStream random(RandomKey(7));
  for (const Field& f : samples()) {
    const field::Traits& traits = f.node()->traits();
    ASSERT_GT(traits.growth_rate(), 0.5);
    for (int i = 0; i < 5000; ++i) {
      const Vec3d p = somewhere(random) * 3;
      Vec3d nearest;
      for (int axis = 0; axis < 3; ++axis)
        nearest[axis] = std::clamp(p[axis], f.bounds().min[axis], f.bounds().max[axis]);
      const double away = (p - nearest).length();
      ASSERT_TRUE(away == 0 || f.value(p) >= traits.growth_rate() * away - 1e-9);
    }
    EXPECT_TRUE(is_finite(traits.bounds_below(0.5)));
  }
}

}  // namespace
}  // namespace vug::sgm
