// SPDX-License-Identifier: Apache-2.0
// Fields and noises along the axes of passages: closed forms, and the guarantees of all fields.
#include "passage_samples.h"

#include <vug/field/value_below.h>
#include <vug/passages/lines/along_flow.h>
#include <vug/passages/lines/centreline.h>
#include <vug/passages/lines/height_above_floor.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::passages {
namespace {

using field::Field;

std::vector<AxisLine> cave_lines() { return axis_lines(random_cave(5, 40), {}); }

Field flow_of(const std::string& noise, const AlongFlowOptions& options) {
  return along_flow(cave_lines(), *field::default_noise(noise), options).field;
}

const std::vector<PassageCase>& line_cases() {
  static const std::vector<PassageCase> cases = {
      {"line", centreline(cave_lines(), 0)},
      {"tubes", centreline(cave_lines(), 0.7)},
      {"height above the floor", height_above_floor(cave_lines())},
      {"fbm", flow_of("fbm", {.stretch = 4, .blend = 0.3})},
      {"scallops", flow_of("scallops", {.stretch = 0.5})},
  };
  return cases;
}

/// Points of which most are within 4 m of the passages.
Vec3d point_of_cave(RandomStream& random) {
  return point_near(line_cases()[1].field, random) + random_vector(random, 2);
}

template <class Check>
void for_each_point(uint64_t key, int count, const Check& check) {
  for (const PassageCase& c : line_cases()) {
    RandomStream random(RandomKey(key).at(c.label));
    for (int i = 0; i < count; ++i) check(c, point_of_cave(random), random);
  }
}

PassageOptions straight() {
  PassageOptions options;
  options.smooth = false;
  return options;
}

TEST(Lines, TheDistanceIsThatToTheNearestLeg) {
  network::Network cave = random_cave(6, 30);
  for (network::Station& station : cave.stations) station.section.reset();
  const Field field = centreline(axis_lines(cave, straight()), 0.25);
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 500; ++i) {
    const Vec3d p = random_vector(random, 60);
    double least = kInfinity;
    for (const network::Leg& leg : cave.legs) {
      const Vec3d from = cave.stations[static_cast<size_t>(leg.from)].position;
      const Vec3d along = network::leg_vector(cave, leg);
      const double t = std::clamp((p - from).dot(along) / along.length2(), 0.0, 1.0);
      least = std::min(least, (p - from - along * t).length());
    }
    ASSERT_NEAR(field.value(p), least - 0.25, 1e-9) << p;
  }
}

TEST(Lines, ValuesBelowALimitAreThoseOfTheField) {
  const Field field = centreline(cave_lines(), 0.25);
  RandomStream random(RandomKey(2));
  int below = 0;
  for (int i = 0; i < 5000; ++i) {
    const Vec3d p = point_of_cave(random);
    const double limit = 4 * random.uniform() - 0.25;
    const double value = field.value(p);
    const double found = field::value_below(*field.node(), field::point(p), limit);
    if (value < limit)
      ASSERT_EQ(found, value) << p;
    else
      ASSERT_GE(found, limit) << p;
    below += value < limit;
  }
  EXPECT_GT(below, 500);
  EXPECT_LT(below, 4500);
}

// A straight passage that descends by 1 in 4, 2 m high: everywhere across it the floor is that of
// its axis, however far from it. A passage 10 m above another one has a floor of its own.
TEST(Lines, TheFloorIsThatOfTheNearestPassage) {
  const auto single = with_radius(network_of({{0, 0, 0}, {40, -10, 0}}, {{0, 1}}), 1);
  const Field sloping = height_above_floor(axis_lines(single, straight()));
  const double below = std::sqrt(16.0 / 17);  // The section is across the passage.
  for (const Vec3d& off : {Vec3d(0, 0, 0), Vec3d(0, 0, 3), Vec3d(0.25, 1, -2), Vec3d(-1, -4, 0)})
    EXPECT_NEAR(sloping.value(Vec3d(20, -5, 0) + off), off.y + below, 1e-9) << off;

  auto two = with_radius(
      network_of({{0, 0, 0}, {40, 0, 0}, {0, 10, 0}, {40, 10, 0}}, {{0, 1}, {2, 3}}), 1);
  const Field levels = height_above_floor(axis_lines(two, straight()));
  EXPECT_NEAR(levels.value({20, 1, 1}), 2, 1e-9);
  EXPECT_NEAR(levels.value({20, 9.5, 1}), 0.5, 1e-9);
  EXPECT_NEAR(levels.value({20, 5, 0}), 1, 1e-9);  // Half way, half of the difference.
}

TEST(Lines, NoisesFollowTheWater) {
  const field::Noise noise = *field::default_noise("scallops");
  // The second leg was surveyed upstream, the longer first one downstream.
  auto bend = network_of({{0, 0, 0}, {0, 0, 30}, {10, 0, 30}}, {{0, 1}, {2, 1}});
  const std::vector<AxisLine> lines = axis_lines(bend, straight());
  const Field flow = along_flow(lines, noise, {.stretch = 2}).field;
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 100; ++i) {
    const Vec3d off = random_vector(random, 1.5);
    // Downstream is +z, so the right is -x.
    ASSERT_NEAR(flow.value(Vec3d(0, 0, 10) + off),
                noise.field.value({0.5 * (10 + off.z), off.y, -off.x}), 1e-6);
    // Beyond the bend downstream is +x, and the distance from the start is 30 m more.
    ASSERT_NEAR(flow.value(Vec3d(7, 0, 30) + off),
                noise.field.value({0.5 * (37 + off.x), off.y, off.z}), 1e-6);
  }
}

TEST(Lines, IntervalsContainSamples) {
  for_each_point(11, 100, [](const PassageCase& c, const Vec3d& middle, RandomStream& random) {
    const Vec3d half = random_vector(random, 1) * std::exp2(random.uniform(-8, 4));
    const Box3d box(middle - abs_of(half), middle + abs_of(half));
    const Interval bounds = c.field.interval(box),
                   natural = c.field.node()->eval(field::region(box));
    for (int k = 0; k < 10; ++k) {
      const double value = c.field.value(middle + half * random_vector(random, 1));
      ASSERT_TRUE(bounds.contains(value)) << c.label;
      ASSERT_TRUE(natural.contains(value)) << c.label;
    }
  });
}

TEST(Lines, RestrictionKeepsValues) {
  for_each_point(12, 100, [](const PassageCase& c, const Vec3d& middle, RandomStream& random) {
    const field::Ball ball{middle, std::exp2(random.uniform(-3, 4))};
    const Field::RestrictedField part = c.field.restricted(ball);
    for (int k = 0; k < 6; ++k) {
      const Vec3d p = ball.centre + random_vector(random, 0.57) * ball.radius;
      const double value = c.field.value(p);
      ASSERT_TRUE(part.range.contains(value)) << c.label << " at " << p;
      ASSERT_EQ(part.field.value(p), value) << c.label << " at " << p;
    }
  });
}

TEST(Lines, LipschitzConstantsHold) {
  for_each_point(13, 2000, [](const PassageCase& c, const Vec3d& p, RandomStream& random) {
    const Vec3d q = p + random_vector(random, 1) * std::exp2(random.uniform(-10, 3));
    ASSERT_LE(std::fabs(c.field.value(p) - c.field.value(q)),
              c.field.lipschitz() * (p - q).length() * (1 + 1e-9) + 1e-7)
        << c.label << " between " << p << " and " << q;
  });
}

TEST(Lines, GradientsEqualDifferences) {
  int smooth = 0;
  for_each_point(14, 300, [&](const PassageCase& c, const Vec3d& p, RandomStream&) {
    const double h = 1e-5, here = c.field.value(p);
    Vec3d slope;
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d step(0.0);
      step[axis] = h;
      const double right = c.field.value(p + step), left = c.field.value(p - step);
      if (std::fabs(right - 2 * here + left) > 2e-3 * h) return;  // A crease.
      slope[axis] = (right - left) / (2 * h);
    }
    ++smooth;
    const field::Gradient g = c.field.gradient(p);
    ASSERT_NEAR(g.value, here, 1e-12) << c.label;
    ASSERT_LT((g.gradient - slope).length(), 2e-2) << c.label << " at " << p;
  });
  EXPECT_GT(smooth, 1200);
}

TEST(Lines, BatchesAgreeWithScalars) {
  field::Scratch scratch;
  constexpr int kPacks = 6;
  for (const PassageCase& c : line_cases()) {
    RandomStream random(RandomKey(15).at(c.label));
    for (int round = 0; round < 20; ++round) {
      Point<Pack> points[kPacks];
      std::vector<Vec3d> where;
      for (auto& point : points) {
        float xyz[3][8];
        const Vec3d around = point_of_cave(random);
        for (int lane = 0; lane < 8; ++lane) {
          const Vec3f p(around + random_vector(random, round % 2 ? 0.1 : 20));
          for (int axis = 0; axis < 3; ++axis) xyz[axis][lane] = p[axis];
          where.push_back(Vec3d(p));
        }
        point = {Pack::load(xyz[0]), Pack::load(xyz[1]), Pack::load(xyz[2])};
      }
      Pack values[kPacks];
      Dual<Pack> duals[kPacks];
      c.field.values(points, kPacks, values, scratch);
      c.field.gradients(points, kPacks, duals, scratch);
      for (size_t i = 0; i < where.size(); ++i) {
        float lanes[8], same[8], slope[8];
        values[i / 8].store(lanes);
        duals[i / 8].v.store(same);
        duals[i / 8].dy.store(slope);
        const field::Gradient g = c.field.gradient(where[i]);
        ASSERT_NEAR(static_cast<double>(lanes[i % 8]), g.value, 1e-3) << c.label;
        ASSERT_NEAR(lanes[i % 8], same[i % 8], 1e-4f) << c.label;
        ASSERT_NEAR(static_cast<double>(slope[i % 8]), g.gradient.y, 0.1 * c.field.lipschitz())
            << c.label;
      }
    }
  }
}

TEST(Lines, NothingIsEverNaN) {
  const double nasty[] = {0.0, 5e-324, 1e-20, -1, 1e6, -1e6};
  for (const PassageCase& c : line_cases())
    for (const double x : nasty)
      for (const double y : nasty)
        for (const double z : nasty) {
          const field::Gradient g = c.field.gradient({x, y, z});
          ASSERT_TRUE(std::isfinite(g.value) && std::isfinite(g.gradient.length())) << c.label;
        }
}

}  // namespace
}  // namespace vug::passages
