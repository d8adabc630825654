// SPDX-License-Identifier: Apache-2.0
// Still water in hollows of any rock: level, shore, leaks; and the rings that drops make on it.
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/passages/water/drop_rings.h>
#include <vug/passages/water/fill.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::passages {
namespace {

/// A block with two bowls of 1 m, 2 m apart at their rims, that a pipe below may connect.
field::Field two_bowls(bool connected) {
  const auto bowl = [](double x) {
    return field::transformed(field::make("sphere", {{"radius", 1.0}}),
                              Transform::translation({x, 0, 0}));
  };
  std::vector<field::Field> cuts = {bowl(-2), bowl(2)};
  if (connected)
    cuts.push_back(field::make(
        "capsule", {{"a", Vec3d(-2, -0.6, 0)}, {"b", Vec3d(2, -0.6, 0)}, {"radius", 0.2}}));
  return field::subtract(field::make("box", {{"size", Vec3d(8, 4, 4)}}), cuts);
}

FillOptions bowls(double level) {
  FillOptions o;
  o.at = {Vec3d(-2, 0, 0)};
  o.level = level;
  o.region = Box3d(Vec3d(-4, -2, -2), Vec3d(4, 2, 2));
  o.cell = 0.05;
  return o;
}

bool is_water(const field::Field& rock, const field::Field& water, const Vec3d& p) {
  return rock.value(p) > 0 && water.value(p) < 0;
}

TEST(Fill, TheWaterHasTheVolumeOfACapAndEndsAtTheLevel) {
  const field::Field rock = two_bowls(false), water = fill_body(rock, bowls(-0.3));
  int inside = 0, other = 0;
  const double step = 0.03;  // The level lies between two layers of points.
  for (double x = -4 + step / 2; x < 4; x += step)
    for (double y = -0.3 - 56.5 * step; y < 2; y += step)
      for (double z = -2 + step / 2; z < 2; z += step)
        if (is_water(rock, water, {x, y, z})) {
          EXPECT_LT(y, -0.3);
          ++(x < 0 ? inside : other);
        }
  const double height = 0.7, cap = kPi * height * height * (1 - height / 3);
  EXPECT_NEAR(inside * step * step * step, cap, 0.01 * cap);
  EXPECT_EQ(other, 0);  // The other bowl is dry.
  EXPECT_NEAR(water.value({-2, 0.2, 0}), 0.5, 1e-6);
}

TEST(Fill, RunsThroughAPipeIntoTheNextHollow) {
  const field::Field rock = two_bowls(true), water = fill_body(rock, bowls(-0.3));
  EXPECT_TRUE(is_water(rock, water, {2, -0.5, 0}));
  const field::Field low = fill_body(rock, bowls(-0.85));
  EXPECT_TRUE(is_water(rock, low, {-2, -0.9, 0}));
  EXPECT_FALSE(is_water(rock, low, {2, -0.9, 0}));
}

TEST(Fill, ReportsLeaksWithTheirPlace) {
  FillOptions narrow = bowls(-0.3);
  narrow.region.max.x = -1.5;  // cuts the bowl
  try {
    filled_hollow(two_bowls(false), narrow);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_input);
    EXPECT_NE(std::string(error.what()).find("leaks out of the region at (-1.525"),
              std::string::npos)
        << error.what();
  }
  narrow.cut = true;
  for (const Polytope& box : filled_hollow(two_bowls(false), narrow))
    EXPECT_LT(box.box.max.x, -1.5 + 2 * narrow.cell);
}

TEST(Fill, RefusesPointsInRockOutsideAndTooManyCells) {
  const field::Field rock = two_bowls(false);
  FillOptions o = bowls(-0.3);
  o.at = {Vec3d(0, -1, 0)};
  EXPECT_THROW(filled_hollow(rock, o), Error);
  o.at = {Vec3d(40, 0, 0)};
  EXPECT_THROW(filled_hollow(rock, o), Error);
  o = bowls(-5);
  EXPECT_THROW(filled_hollow(rock, o), Error);
  o = bowls(-0.3);
  o.cell = 1e-4;
  EXPECT_THROW(filled_hollow(rock, o), Error);
}

TEST(Fill, IsTheSameForAnyNumberOfThreads) {
  const auto boxes = [](int threads) {
    return with_threads(threads, [] { return filled_hollow(two_bowls(true), bowls(-0.3)); });
  };
  const std::vector<Polytope> one = boxes(1), seven = boxes(7);
  ASSERT_EQ(one.size(), seven.size());
  for (size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].box, seven[i].box);
}

TEST(Fill, TheFieldIsALowerBoundWithSlopeOne) {
  const field::Field water = fill_body(two_bowls(true), bowls(-0.3));
  water.value(Vec3d(0.0));  // computes it
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p(random.uniform(-5, 5), random.uniform(-3, 3), random.uniform(-3, 3));
    const Vec3d q = p + Vec3d(random.normal(), random.normal(), random.normal()) * 0.2;
    EXPECT_LE(std::fabs(water.value(p) - water.value(q)), (p - q).length() + 1e-9);
    const Interval range = water.interval(Box3d(p - Vec3d(0.1), p + Vec3d(0.1)));
    EXPECT_TRUE(range.lo <= water.value(p) && water.value(p) <= range.hi);
  }
}

TEST(DropRings, AreCirclesAroundTheDrops) {
  DropRingsOptions o;
  o.points = {Vec3d(0.3, 5, -0.2)};
  const field::Noise rings = drop_rings(o);
  double highest = 0;
  for (int i = 0; i < 4000; ++i) {
    const double r = i * 1e-4, h = rings.field.value({0.3 + r, 0, -0.2});
    EXPECT_NEAR(h, rings.field.value({0.3 - 0.6 * r, 7, -0.2 + 0.8 * r}), 1e-9);
    highest = std::max(highest, h);
  }
  EXPECT_GT(highest, 0.2);
  // Nothing beyond the largest radius and half a packet.
  EXPECT_EQ(rings.field.value({0.3 + o.reach + 2 * o.wavelength, 0, -0.2}), 0);
}

TEST(DropRings, StayWithinTheirBounds) {
  DropRingsOptions o;
  RandomStream random(RandomKey(8));
  for (int i = 0; i < 30; ++i)
    o.points.push_back({random.uniform(-1, 1), 0, random.uniform(-1, 1)});
  const field::Noise rings = drop_rings(o);
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p(random.uniform(-1, 1), 0, random.uniform(-1, 1));
    const field::Gradient here = rings.field.gradient(p);
    EXPECT_LE(std::fabs(here.value), 1);
    EXPECT_LE(here.gradient.length(), rings.field.lipschitz());
    EXPECT_EQ(here.gradient.y, 0);
    const Vec3d q = p + Vec3d(1e-6, 0, 0);
    EXPECT_NEAR((rings.field.value(q) - here.value) / 1e-6, here.gradient.x,
                1e-3 * rings.field.lipschitz());
    const Interval range = rings.field.interval(Box3d(p - Vec3d(0.003), p + Vec3d(0.003)));
    EXPECT_TRUE(range.lo <= here.value && here.value <= range.hi);
  }
  o.points.resize(1001);
  EXPECT_THROW(drop_rings(o), Error);
}

}  // namespace
}  // namespace vug::passages
