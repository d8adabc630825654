// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/sgm/glue.h>

#include <gtest/gtest.h>

namespace vug::sgm {
namespace {

Vec3d unit(RandomStream& random) {
  for (;;) {
    const Vec3d v(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
    if (v.length() > 0.1 && v.length() < 1) return v.normalized();
  }
}

TEST(GlueTransform, MakesALabelOfAnyTwoBonds) {
  for (uint64_t seed = 0; seed < 1000; ++seed) {
    RandomStream random(RandomKey(seed).at("glue"));
    const Bond fixed{unit(random) * 5.0, unit(random)}, moving{unit(random) * 3.0, unit(random)};
    const Transform map = glue_transform(fixed, moving);
    const Bond moved{map.point(moving.point), map.vector(moving.direction)};
    ASSERT_TRUE(makes_label(fixed, moved, 1, 1e-12)) << seed;
    ASSERT_NEAR(map.determinant(), 1, 1e-12);
  }
}

TEST(GlueTransform, RotatesOnlyIfNecessary) {
  const Bond fixed{{1, 2, 3}, {1, 0, 0}};
  for (const Vec3d& d : {Vec3d(-1, 0, 0), Vec3d(0, 0, 0)}) {
    const Transform map = glue_transform(fixed, {{5, 5, 5}, d});
    EXPECT_EQ(map.vector({1, 0, 0}), Vec3d(1, 0, 0));
    EXPECT_EQ(map.vector({0, 1, 0}), Vec3d(0, 1, 0));
    EXPECT_EQ(map.point({5, 5, 5}), Vec3d(1, 2, 3));
  }
  EXPECT_LT(
      (glue_transform(fixed, {{0, 0, 0}, {1, 0, 0}}).vector({1, 0, 0}) - Vec3d(-1, 0, 0)).length(),
      1e-12);
}

TEST(OppositeBond, IsOnTheFacingSide) {
  const Shape cuboid = make_shape("box", box({1, 2, 3}));
  for (int s = 0; s < 6; ++s) {
    const Label side = static_cast<Label>(s);
    const auto i = opposite_bond(cuboid, side, RandomKey(1));
    ASSERT_TRUE(i);
    EXPECT_EQ(cuboid.bonds[*i].direction, -direction(side));
  }
  // A half-space has its wall on one side only, so it is rotated to fit.
  EXPECT_EQ(opposite_bond(make_shape("ground", solid(TestHalfSpace{{0, 1, 0}})), Label::plus_x,
                          RandomKey(1)),
            0u);
  EXPECT_FALSE(opposite_bond(Shape{}, Label::plus_x, RandomKey(1)));
}

TEST(Compound, OfEqualBallsIsAChain) {
  // Radius 1 pressed in by a quarter of 2: centres 1.5 apart.
  const std::vector<Shape> pieces(3, make_shape("ball", ball(1)));
  const Shape chain = compound(pieces, Label::plus_x, 0.25, RandomKey(1));
  const Box3d& box = chain.field.bounds();
  EXPECT_NEAR(box.min.x, -1, 1e-12);
  EXPECT_NEAR(box.max.x, 4, 1e-12);
  for (const double x : {0.0, 1.5, 3.0}) EXPECT_NEAR(chain.field.value({x, 0, 0}), -1, 1e-12);
  ASSERT_EQ(chain.bonds.size(), 6u);
  EXPECT_NEAR(chain.bonds[1].point.x, 4, 1e-9);
  EXPECT_EQ(chain.name, "(ball + ball + ball)");
}

TEST(Compound, OfOnePieceIsThatPiece) {
  const Shape one = compound({make_shape("ball", ball(1))}, Label::random, 0.25, RandomKey(1));
  EXPECT_EQ(one.name, "ball");
}

}  // namespace
}  // namespace vug::sgm
