// SPDX-License-Identifier: Apache-2.0
// Statements of a field about a region hold for every point in it: intervals, restrictions,
// Lipschitz constants, bounds.
#include "sweep.h"

#include <vug/field/translated.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

/// Intervals are rounded to nearest, over a few nested operations.
double slack(const Vec3d& p, double value) { return 1e-12 * (1 + p.length() + std::fabs(value)); }

TEST(Sweep, IntervalsContainSamples) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(11).at(c.label));
    for (int box_index = 0; box_index < 170; ++box_index) {  // 6 cases: 10,200 samples per kind.
      const Vec3d middle = random_point(random, 2.5);
      const double scale = std::exp2(random.uniform(-10, 2));
      const Vec3d half = Vec3d(random.uniform(), random.uniform(), random.uniform()) * scale;
      const Box3d box(middle - half, middle + half);
      const Interval bounds = c.field.interval(box);
      for (int i = 0; i < 10; ++i) {
        const Vec3d p = middle + half * random_point(random, 1);
        const double value = c.field.value(p);
        ASSERT_GE(value, bounds.lo - slack(p, value)) << c.label << " at " << p;
        ASSERT_LE(value, bounds.hi + slack(p, value)) << c.label << " at " << p;
      }
    }
  });
}

TEST(Sweep, NaturalIntervalsContainSamples) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(12).at(c.label));
    for (int box_index = 0; box_index < 100; ++box_index) {
      const Vec3d middle = random_point(random, 2.5);
      const Vec3d half(std::exp2(random.uniform(-10, 2)));
      const Interval bounds = c.field.node()->eval(region(Box3d(middle - half, middle + half)));
      for (int i = 0; i < 10; ++i) {
        const Vec3d p = middle + half * random_point(random, 1);
        const double value = c.field.value(p);
        ASSERT_FALSE(value < bounds.lo - slack(p, value)) << c.label << " at " << p;
        ASSERT_FALSE(value > bounds.hi + slack(p, value)) << c.label << " at " << p;
      }
    }
  });
}

TEST(Sweep, RestrictionKeepsValues) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(13).at(c.label));
    for (int ball_index = 0; ball_index < 60; ++ball_index) {
      const Ball ball{random_point(random, 2.5), std::exp2(random.uniform(-8, 1))};
      const Field::RestrictedField part = c.field.restricted(ball);
      for (int i = 0; i < 10; ++i) {
        const Vec3d p = random_point(random, ball);
        const double value = c.field.value(p);
        ASSERT_TRUE(part.range.contains(value)) << c.label << " at " << p;
        ASSERT_EQ(part.field.value(p), value) << c.label << " at " << p;
      }
    }
  });
}

TEST(Sweep, TranslationMovesValues) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(16).at(c.label));
    for (const double far : {2.0, 5000.0}) {
      const Vec3d by = random_point(random, far);
      const Field moved = translated(c.field, by), back = translated(moved, -by);
      EXPECT_EQ(moved.exactness(), c.field.exactness()) << c.label;
      int differ = 0;
      for (int i = 0; i < 200; ++i) {
        const Vec3d p = random_point(random, 2.5);
        const double value = c.field.value(p),
                     allowed = 1e-11 * (1 + far) * (1 + c.field.lipschitz()) + 1e-12 * value;
        differ += std::fabs(moved.value(p + by) - value) > allowed ? 1 : 0;
        differ += std::fabs(back.value(p) - value) > allowed ? 1 : 0;
        if (moved.digest() == c.field.digest()) {
          EXPECT_EQ(moved.value(p), value) << c.label;
        }
      }
      // Values may jump where the number of copies changes, and parts are chosen by cells.
      EXPECT_LE(differ, 2) << c.label << " by " << by;
    }
  });
}

TEST(Sweep, LipschitzClaimHolds) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(14).at(c.label));
    for (int i = 0; i < 2000; ++i) {
      const Vec3d p = random_point(random, 2.5);
      const Vec3d q = p + random_point(random, std::exp2(random.uniform(-12, 1)));
      const double change = std::fabs(c.field.value(p) - c.field.value(q));
      ASSERT_LE(change, c.field.lipschitz() * (p - q).length() * (1 + 1e-9) + 1e-10)
          << c.label << " between " << p << " and " << q;
    }
  });
}

TEST(Sweep, BoundsHoldTheInsideAndTheFieldGrowsBeyond) {
  for_each_case([&](const SweepCase& c) {
    RandomStream random(RandomKey(15).at(c.label));
    const Box3d& box = c.field.bounds();
    for (int i = 0; i < 3000; ++i) {
      const Vec3d p = random_point(random, 4);
      const double value = c.field.value(p);
      if (box.isEmpty()) {
        ASSERT_GT(value, 0) << c.label << " at " << p;
        continue;
      }
      double away2 = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double off = std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0});
        away2 += off * off;
      }
      ASSERT_GE(value, away2 > 0 ? c.field.node()->traits().growth_rate() * std::sqrt(away2) - 1e-9
                                 : -kInfinity)
          << c.label << " at " << p;
    }
  });
}

}  // namespace
}  // namespace vug::field
