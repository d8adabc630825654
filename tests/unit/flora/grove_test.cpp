// SPDX-License-Identifier: Apache-2.0
// Stems on the ground, filtered by growing conditions.
#include "stands.h"

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/field/registry.h>
#include <vug/flora/grove.h>
#include <vug/mesh/shapes.h>

#include <cmath>

namespace vug::flora {
namespace {

using field::Field;

Field ball(const Vec3d& center, double radius) {
  return field::make(
      "translate",
      {{"field", field::as_value(field::make("sphere", {{"radius", radius}}))}, {"by", center}});
}
Field ground_at(double height) {
  return field::make("translate", {{"field", field::as_value(field::make("half_space"))},
                                   {"by", Vec3d(0, height, 0)}});
}

GroveOptions options(double density) {
  GroveOptions o;
  o.density = density;
  o.key = RandomKey(3);
  return o;
}

TEST(Ground, OfAFieldIsExactAndFacesUp) {
  const Ground dome = ground_of(ball({1, 0, 2}, 3));
  for (const Vec2d& off : {Vec2d(0, 0), Vec2d(1, 2), Vec2d(-2.9, 0.1)}) {
    const auto foot = dome(Vec2d(1, 2) + off);
    ASSERT_TRUE(foot);
    const double height = std::sqrt(9 - off.length2());
    EXPECT_NEAR(foot->position.y, height, 1e-7);
    EXPECT_LT((foot->normal - Vec3d(off.x, height, off.y) / 3).length(), 1e-6);
  }
  EXPECT_FALSE(dome({4.2, 2}));
}

TEST(Ground, IsFoundBelowARoof) {
  const Field floor_and_roof = field::make(
      "union", {{"of", List{field::as_value(ground_at(0)), field::as_value(ball({0, 6, 0}, 2))}}});
  GroundOptions under;
  under.from = 3;
  under.headroom = 10;
  const auto foot = ground_of(floor_and_roof, under)({0, 0});
  ASSERT_TRUE(foot);
  EXPECT_NEAR(foot->position.y, 0, 1e-7);
  EXPECT_NEAR(foot->clearance, 4, 0.01);
  GroundOptions above;
  above.from = 20;
  EXPECT_NEAR(ground_of(floor_and_roof, above)({0, 0})->position.y, 8, 1e-7);
  GroundOptions within;
  within.from = 6;
  EXPECT_FALSE(ground_of(floor_and_roof, within)({0, 0}));
  EXPECT_THROW(ground_of(field::make("complement", {{"field", field::as_value(ground_at(0))}})),
               Error);  // No upper bound.
}

TEST(Ground, OfAMeshIsOnItsTriangles) {
  const auto box =
      std::make_shared<const mesh::Mesh>(mesh::box_mesh(Box3d(Vec3d(0, -1, 0), Vec3d(4, 2, 4))));
  const auto foot = ground_of(box)({1.3, 2.1});
  ASSERT_TRUE(foot);
  EXPECT_EQ(foot->position, Vec3d(1.3, 2, 2.1));
  EXPECT_EQ(foot->normal, Vec3d(0, 1, 0));
  EXPECT_FALSE(ground_of(box)({-0.1, 2}));
  GroundOptions below;
  below.from = 0;
  EXPECT_NEAR(ground_of(box, below)({1, 1})->clearance, 3, 1e-6);
}

TEST(Grove, StandsOnTheGroundExceptOnSteepSlopes) {
  GroveOptions o = options(4);
  o.ground = ground_of(ball({0, 0, 0}, 5));
  o.steepest = 40 * kPi / 180;
  const std::vector<Stem> stems = grove(Plot({{-6, -6}, {6, -6}, {6, 6}, {-6, 6}}), o);
  // The cap up to 40 degrees has a plan of radius 5 sin 40.
  const double expected = 4 * kPi * std::pow(5 * std::sin(o.steepest), 2);
  EXPECT_NEAR(static_cast<double>(stems.size()), expected, 5 * std::sqrt(expected));
  for (const Stem& stem : stems) {
    EXPECT_NEAR(stem.base.position.length(), 5, 1e-6);
    EXPECT_GE(stem.base.normal.y, std::cos(o.steepest));
  }
}

TEST(Grove, StemsAvoidRock) {
  GroveOptions o = options(4);
  const Field rock = ball({5, 0, 5}, 2), high = ball({2, 5, 2}, 1.5);
  o.avoid = {rock, high};
  o.margin = 0.5;
  const Plot plot(square(10));
  const std::vector<Stem> low = grove(plot, o);
  o.headroom = 8;
  const std::vector<Stem> tall = grove(plot, o);
  const auto clear = [](const Stem& stem, const Vec2d& middle, double radius) {
    return (Vec2d(stem.base.position.x, stem.base.position.z) - middle).length() >= radius - 1e-9;
  };
  bool some_under = false;
  for (const Stem& stem : low) {
    EXPECT_TRUE(clear(stem, {5, 5}, 2.5));
    some_under = some_under || !clear(stem, {2, 2}, 1.9);
  }
  EXPECT_TRUE(some_under);
  for (const Stem& stem : tall) EXPECT_TRUE(clear(stem, {2, 2}, 1.98));  // Steps of 1 cm.
  const double expected = 4 * (100 - kPi * 2.5 * 2.5);
  EXPECT_NEAR(static_cast<double>(low.size()), expected, 5 * std::sqrt(expected));
  EXPECT_LT(tall.size(), low.size());
}

TEST(Grove, KeepsTheSpacingAndTheEarlierStem) {
  GroveOptions o = options(2);
  const std::vector<Stem> all = grove(Plot(square(30)), o);
  o.spacing = 0.6;
  const std::vector<Stem> some = grove(Plot(square(30)), o);
  EXPECT_LT(some.size(), all.size());
  EXPECT_EQ(some[0].key.state(), all[0].key.state());
  for (size_t i = 0; i < some.size(); ++i)
    for (size_t j = 0; j < i; ++j)
      ASSERT_GE((some[i].base.position - some[j].base.position).length(), 0.6);
}

TEST(Grove, DiametersAreNormalWithinTheirBounds) {
  GroveOptions o = options(20);
  o.diameter = 0.1;
  o.diameter_spread = 0.02;
  double sum = 0, squares = 0;
  const std::vector<Stem> stems = grove(Plot(square(40)), o);
  for (const Stem& stem : stems) {
    EXPECT_GE(stem.diameter, 0.05);
    EXPECT_LE(stem.diameter, 0.15);
    sum += stem.diameter, squares += stem.diameter * stem.diameter;
  }
  const auto n = static_cast<double>(stems.size());
  EXPECT_NEAR(sum / n, 0.1, 5 * 0.02 / std::sqrt(n));
  // The variance of a normal deviate truncated at 2.5 deviations is 0.911 of the untruncated one.
  EXPECT_NEAR((squares / n - sum / n * sum / n) / (0.02 * 0.02), 0.911, 0.05);
}

TEST(Grove, TheNearestDiameterIsChosen) {
  const std::vector<double> of = {0.05, 0.1, 0.1, 0.2};
  EXPECT_EQ(nearest_diameter(of, 0.06, RandomKey(1)), 0u);
  EXPECT_EQ(nearest_diameter(of, 0.15, RandomKey(1)), 3u);  // By ratio.
  std::array<int, 4> taken{};
  for (uint64_t i = 0; i < 1000; ++i) ++taken[nearest_diameter(of, 0.11, RandomKey(i))];
  EXPECT_EQ(taken[0] + taken[3], 0);
  EXPECT_NEAR(taken[1], 500, 80);
}

TEST(Grove, DoesNotDependOnThreads) {
  const auto run = [](int threads) {
    return with_threads(threads, [&] {
      GroveOptions o = options(3);
      o.ground = ground_of(ball({10, -20, 10}, 25));
      o.retention = [](const GroundPoint& foot) { return foot.position.x / 20; };
      o.diameter = 0.1, o.diameter_spread = 0.03;
      std::vector<double> numbers;
      for (const Stem& stem : grove(Plot(square(20)), o))
        numbers.insert(numbers.end(), {stem.base.position.x, stem.base.position.y, stem.diameter});
      return numbers;
    });
  };
  const std::vector<double> one = run(1);
  EXPECT_GT(one.size(), 1000u);
  EXPECT_EQ(run(2), one);
  EXPECT_EQ(run(7), one);
}

}  // namespace
}  // namespace vug::flora
