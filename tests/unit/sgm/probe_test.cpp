// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/sgm/probe.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::sgm {
namespace {

TEST(FirstHit, OfABallIsTheQuadraticsRoot) {
  const Field f = moved(ball(0.7), {3, 0.2, -0.1});
  // (3 - t)^2 + 0.2^2 + 0.1^2 = 0.7^2
  EXPECT_NEAR(*first_hit(f, Vec3d(0), {1, 0, 0}, 10), 3 - std::sqrt(0.49 - 0.05), 1e-13);
  EXPECT_FALSE(first_hit(f, Vec3d(0), {1, 0, 0}, 2));
  EXPECT_FALSE(first_hit(f, Vec3d(0), {0, 1, 0}, 10));
  EXPECT_EQ(*first_hit(f, {3, 0, 0}, {1, 0, 0}, 10), 0);
}

TEST(SupportPoint, OfATiltedBoxIsItsCorner) {
  const Vec3d half(1, 0.5, 0.25);
  const Transform turn = Transform::rotation({1, 2, 3}, 0.7);
  const Field f = field::transformed(box(half), turn);
  for (int axis = 0; axis < 3; ++axis) {
    double reach = 0;  // sum of |R_ij| h_j
    for (int j = 0; j < 3; ++j) reach += std::fabs(turn.column(j)[axis]) * half[j];
    for (const int sign : {-1, 1}) {
      const auto p = support_point(f, axis, sign);
      ASSERT_TRUE(p);
      EXPECT_NEAR((*p)[axis], sign * reach, 1e-4);
      EXPECT_NEAR(f.value(*p), 0, 1e-9);
    }
  }
}

/// A ball in bounds a thousand times its size.
struct Speck {
  template <class T>
  T distance(const field::Point<T>& p) const {
    return field::length(p - field::constant<T>({1, 5.03, 4.9})) - T(0.01);
  }
  Box3d bounds() const { return {Vec3d(-7), Vec3d(7)}; }
};

TEST(SupportPoint, FindsASolidBetweenTheRays) {
  const auto p = support_point(solid(Speck{}), 1, 1);
  ASSERT_TRUE(p);
  EXPECT_NEAR(p->y, 5.04, 3e-5);  // 1e-6 of the size, 24
}

TEST(InnerPoint, FindsThinLensesAndNothing) {
  const auto lens = [](double distance) {
    return field::intersect({ball(1), moved(ball(1), {distance, 0, 0})});
  };
  for (const double distance : {0.5, 1.9, 1.99}) {
    const auto p = inner_point(lens(distance));
    ASSERT_TRUE(p) << distance;
    EXPECT_LT(lens(distance).value(*p), 0);
  }
  EXPECT_FALSE(inner_point(lens(2.01)));
  EXPECT_FALSE(inner_point(Field()));
  EXPECT_FALSE(inner_point(field::subtract(ball(1), {ball(1)})));
  EXPECT_TRUE(inner_point(solid(TestHalfSpace{{0, 1, 0}})));
}

}  // namespace
}  // namespace vug::sgm
