// SPDX-License-Identifier: Apache-2.0
// Equation (5) compared with closed forms, on the unclipped fields that productions use.
#include "samples.h"

#include <vug/sgm/probe.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::sgm {
namespace {

Vec3d direction(RandomStream& random) {
  const double z = random.uniform(-1, 1), phi = random.uniform(0, 2 * kPi);
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(phi), r * std::sin(phi), z};
}

TEST(Morph, OfConcentricBallsIsTheBallBetween) {
  const Field f = field::morph(ball(30), ball(60), 0.52);
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d u = direction(random);
    ASSERT_NEAR(100 - *first_hit(f, u * 100, -u, 100), 0.48 * 30 + 0.52 * 60, 1e-11);
  }
}

TEST(Morph, OfTwoBallsIsTheEllipsoidWithTheirCentresAsFoci) {
  // (|p - c1| + |p - c2|) / 2 = R: semi-axes R and sqrt(R^2 - D^2/4).
  for (const double distance : {0.1, 1.0, 1.9}) {
    const Field f = field::morph(moved(ball(1), {-distance / 2, 0, 0}),
                                 moved(ball(1), {distance / 2, 0, 0}), 0.5);
    const double a = 1, b = std::sqrt(1 - distance * distance / 4);
    RandomStream random(RandomKey(2));
    for (int i = 0; i < 1000; ++i) {
      const Vec3d u = direction(random);
      ASSERT_NEAR(f.value({a * u.x, b * u.y, b * u.z}), 0, 1e-14);
    }
  }
  for (const double distance : {2.0, 2.5})
    EXPECT_FALSE(inner_point(field::morph(ball(1), moved(ball(1), {distance, 0, 0}), 0.5)));
}

TEST(Morph, EndsAreTheOperandsBitForBit) {
  const Field a = torus(1, 0.3), b = moved(box({1, 2, 0.5}), {0.3, 0, 0});
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 10000; ++i) {
    const Vec3d p = direction(random) * random.uniform(0, 5);
    ASSERT_EQ(field::morph(a, b, 0).value(p), a.value(p));
    ASSERT_EQ(field::morph(a, b, 1).value(p), b.value(p));
  }
}

// "Always base * newest": a fold in derivation order, so later shapes have more weight among equal
// ones.
TEST(Morph, ProductionsFoldInOrder) {
  Options whole;
  whole.reach = Reach::whole;
  whole.overlap.morph = 0.5;  // Centres coincide with bonds.
  Growth growth(whole);
  growth.apply(step(Operation::unite, ball(3)), RandomKey(1));
  const double amounts[] = {0.3, 0.4};
  std::vector<Field> placed;
  for (const double amount : amounts) {
    ProductionStep melt = step(Operation::morph, ball(3));
    melt.amount = amount;
    placed.push_back(growth.apply(melt, RandomKey(2)).field);
  }
  RandomStream random(RandomKey(4));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = direction(random) * random.uniform(0, 9);
    const double first = 0.7 * ball(3).value(p) + 0.3 * placed[0].value(p);
    ASSERT_NEAR(growth.field().value(p), 0.6 * first + 0.4 * placed[1].value(p), 1e-12);
  }
}

}  // namespace
}  // namespace vug::sgm
