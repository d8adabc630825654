// SPDX-License-Identifier: Apache-2.0
// Properties of swept fields: closed forms of cylinders, cones and tori; and statements about
// regions (intervals, restrictions, slopes, bounds) at random points.
#include "passage_samples.h"

#include <vug/base/error.h>
#include <vug/passages/sweep/sweep.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

using field::Field;

Sweep chain_of(const std::vector<SectionFrame>& frames) {
  Sweep out;
  for (size_t i = 0; i + 1 < frames.size(); ++i)
    out.segments.emplace_back(frames[i], frames[i + 1]);
  return out;
}

TEST(Sweep, AStraightCylinderIsExact) {
  const SectionPtr circle = make_family("tube")->fit({3, 3, 0});
  const Vec3d from(1, 2, 3), to(4, -5, 9), axis = (to - from).normalized();
  const Field field = sweep(chain_of({{from, {1, 0, 0}, {0, 1, 0}, circle},
                                      {0.3 * from + 0.7 * to, {1, 0, 0}, {0, 1, 0}, circle},
                                      {to, {1, 0, 0}, {0, 1, 0}, circle}}));
  EXPECT_EQ(field.exactness(), field::Exactness::eikonal);
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = 0.5 * (from + to) + random_vector(random, 8);
    const double s = std::clamp((p - from).dot(axis), 0.0, (to - from).length());
    const double expected = (p - from - axis * s).length() - 1.5;
    ASSERT_NEAR(field.value(p), expected, 1e-9) << p;
  }
}

TEST(Sweep, AConeHasItsRadiusEverywhere) {
  const SectionFamilyPtr tube = make_family("tube");
  const Field field = sweep(chain_of({{{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, tube->fit({2, 2, 0})},
                                      {{4, 0, 0}, {0, 0, 1}, {0, 1, 0}, tube->fit({4, 4, 0})}}));
  for (const double x : {0.0, 1.0, 2.5, 4.0})
    for (const double angle : {0.0, 1.0, 4.0}) {
      const double r = 1 + 0.25 * x;
      EXPECT_NEAR(field.value({x, r * std::cos(angle), r * std::sin(angle)}), 0, 1e-12);
    }
}

// Halfway between two ellipses lies the ellipse of their mean half-axes, turned by half the angle.
TEST(Sweep, ALoftedTubeIsAnEllipseInItsMiddle) {
  const SectionFamilyPtr tube = make_family("tube");
  for (const double turn : {0.0, 0.3, -0.4}) {
    const auto frame = [&](double x, double angle, double width, double height) {
      return SectionFrame{{x, 0, 0},
                          {0, std::sin(angle), std::cos(angle)},
                          {0, std::cos(angle), -std::sin(angle)},
                          tube->fit({width, height, 0})};
    };
    const Segment segment(frame(0, 0, 3, 2), frame(4, turn, 2, 4));
    const SectionPtr middle = tube->fit({2.5, 3, 0});
    const double c = std::cos(0.5 * turn), s = std::sin(0.5 * turn);
    RandomStream random(RandomKey(3));
    for (int i = 0; i < 500; ++i) {
      const double y = random.uniform(-3, 3), z = random.uniform(-3, 3);
      ASSERT_NEAR(segment.value(field::point({2, y, z})),
                  segment.scale() * middle->distance(c * z + s * y, c * y - s * z), 1e-9)
          << turn << " at " << y << " " << z;
    }
    EXPECT_GT(segment.scale(), 0.9);
  }
}

// A ring of radius R and tube r with r / R = 1/2: the distance is |(|(x, z)| - R, y)| - r.
TEST(Sweep, ATorusIsCorrectWithinTwoPercent) {
  const double ring = 2, tube = 1;
  const SectionPtr circle = make_family("tube")->fit({2 * tube, 2 * tube, 0});
  std::vector<SectionFrame> frames;
  constexpr int kPieces = 32;
  for (int i = 0; i <= kPieces; ++i) {
    const double angle = 2 * kPi * i / kPieces;
    frames.push_back({Vec3d(std::cos(angle), 0, std::sin(angle)) * ring,
                      {std::cos(angle), 0, std::sin(angle)},
                      {0, 1, 0},
                      circle});
  }
  const Field field = sweep(chain_of(frames));
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 3000; ++i) {
    const Vec3d p = random_vector(random, 4);
    const double around = std::hypot(p.x, p.z) - ring;
    const double expected = std::hypot(around, p.y) - tube;
    ASSERT_NEAR(field.value(p), expected, 0.02 * tube) << p;
  }
}

TEST(Sweep, IntervalsContainSamples) {
  for (const PassageCase& c : passage_cases()) {
    RandomStream random(RandomKey(11).at(c.label));
    for (int i = 0; i < 120; ++i) {
      const Vec3d middle = point_near(c.field, random);
      const Vec3d half = random_vector(random, 1) * std::exp2(random.uniform(-8, 4));
      const Box3d box(middle - abs_of(half), middle + abs_of(half));
      const Interval bounds = c.field.interval(box),
                     natural = c.field.node()->eval(field::region(box));
      for (int k = 0; k < 10; ++k) {
        const double value = c.field.value(middle + half * random_vector(random, 1));
        ASSERT_TRUE(bounds.contains(value)) << c.label;
        ASSERT_TRUE(natural.contains(value)) << c.label;
      }
    }
  }
}

TEST(Sweep, RestrictionKeepsValues) {
  for (const PassageCase& c : passage_cases()) {
    RandomStream random(RandomKey(12).at(c.label));
    for (int i = 0; i < 60; ++i) {
      field::Ball ball{point_near(c.field, random), std::exp2(random.uniform(0, 6))};
      Field outer = c.field;
      // Smaller and smaller balls inside, as the octree of a level set has them.
      for (int depth = 0; depth < 4; ++depth) {
        const Field::RestrictedField part = outer.restricted(ball);
        for (int k = 0; k < 6; ++k) {
          const Vec3d p = ball.centre + random_vector(random, 0.57) * ball.radius;
          const double value = c.field.value(p);
          ASSERT_TRUE(part.range.contains(value)) << c.label << " at " << p;
          ASSERT_EQ(part.field.value(p), value) << c.label << " at " << p;
        }
        ball.centre += random_vector(random, 0.28) * ball.radius;
        ball.radius *= 0.5;
        outer = part.field;
      }
    }
  }
}

// Small balls where passages meet keep both arms of a fillet.
TEST(Sweep, RestrictionKeepsFillets) {
  const auto network = with_radius(
      network_of({{0, 0, 0}, {20, 0, 0}, {-20, 0, 0}, {3, 0, 20}}, {{0, 1}, {2, 0}, {0, 3}}), 1.5);
  PassageOptions options;
  options.fillet = 1;
  const Field filleted = passages(network, options);
  options.fillet = 0;
  const Field sharp = passages(network, options);
  field::Scratch scratch;
  RandomStream random(RandomKey(18));
  int within = 0;
  for (int i = 0; i < 3000; ++i) {
    const field::Ball ball{random_vector(random, 5), random.uniform(0.001, 0.1)};
    const Field part = filleted.restricted({ball.centre, 4}).field.restricted(ball).field;
    const Vec3d p(Vec3f(ball.centre + random_vector(random, 0.5) * ball.radius));
    const double value = filleted.value(p);
    within += value < sharp.value(p) - 0.01;
    ASSERT_EQ(part.value(p), value) << p;
    const Point<Pack> pack = field::constant<Pack>(p);
    Pack batch;
    part.values(&pack, 1, &batch, scratch);
    ASSERT_NEAR(static_cast<double>(_mm256_cvtss_f32(batch.v)), value, 1e-4) << p;
  }
  EXPECT_GT(within, 100);
}

// Balls that hold hundreds of segments, which are evaluated with the BVH of the whole.
TEST(Sweep, LargeRestrictionsKeepValues) {
  const Field whole = passages(random_cave(8, 300));
  field::Scratch scratch;
  RandomStream random(RandomKey(17));
  for (int i = 0; i < 20; ++i) {
    const field::Ball ball{point_near(whole, random), random.uniform(50, 400)};
    const Field part = whole.restricted(ball).field;
    const field::Ball inner{ball.centre, 0.1 * ball.radius};
    const Field smaller = part.restricted(inner).field;
    for (int k = 0; k < 10; ++k) {
      const Vec3d p(Vec3f(ball.centre + random_vector(random, 0.05) * ball.radius));
      const double value = whole.value(p);
      ASSERT_EQ(part.value(p), value) << p;
      ASSERT_EQ(smaller.value(p), value) << p;
      const Point<Pack> pack = field::constant<Pack>(p);
      Pack batch;
      part.values(&pack, 1, &batch, scratch);
      ASSERT_NEAR(static_cast<double>(_mm256_cvtss_f32(batch.v)), value, 1e-4) << p;
    }
  }
}

TEST(Sweep, LipschitzConstantIsOne) {
  for (const PassageCase& c : passage_cases()) {
    EXPECT_EQ(c.field.lipschitz(), 1) << c.label;
    RandomStream random(RandomKey(13).at(c.label));
    for (int i = 0; i < 3000; ++i) {
      const Vec3d p = point_near(c.field, random);
      const Vec3d q = p + random_vector(random, 1) * std::exp2(random.uniform(-10, 3));
      ASSERT_LE(std::fabs(c.field.value(p) - c.field.value(q)),
                (p - q).length() * (1 + 1e-9) + 1e-10)
          << c.label << " between " << p << " and " << q;
    }
  }
}

TEST(Sweep, GradientsEqualDifferences) {
  for (const PassageCase& c : passage_cases()) {
    RandomStream random(RandomKey(14).at(c.label));
    int smooth = 0;
    for (int i = 0; i < 400; ++i) {
      const Vec3d p = point_near(c.field, random);
      const double h = 1e-5, here = c.field.value(p);
      Vec3d slope;
      bool crease = false;
      for (int axis = 0; axis < 3; ++axis) {
        Vec3d step(0.0);
        step[axis] = h;
        const double right = c.field.value(p + step), left = c.field.value(p - step);
        crease = crease || std::fabs(right - 2 * here + left) > 2e-3 * h;
        slope[axis] = (right - left) / (2 * h);
      }
      if (crease) continue;
      ++smooth;
      const field::Gradient g = c.field.gradient(p);
      ASSERT_EQ(g.value, here) << c.label;
      ASSERT_LT((g.gradient - slope).length(), 5e-3) << c.label << " at " << p;
    }
    EXPECT_GT(smooth, 200) << c.label;
  }
}

TEST(Sweep, BatchesAgreeWithScalars) {
  field::Scratch scratch;
  for (const PassageCase& c : passage_cases()) {
    RandomStream random(RandomKey(15).at(c.label));
    for (int round = 0; round < 30; ++round) {
      constexpr int kPacks = 6;
      Point<Pack> points[kPacks];
      std::vector<Vec3d> where;
      for (auto& point : points) {
        float xyz[3][8];
        for (int lane = 0; lane < 8; ++lane) {
          const Vec3f p(point_near(c.field, random));
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
        float lanes[8], same[8];
        values[i / 8].store(lanes);
        duals[i / 8].v.store(same);
        ASSERT_NEAR(static_cast<double>(lanes[i % 8]), c.field.value(where[i]), 1e-4) << c.label;
        ASSERT_NEAR(lanes[i % 8], same[i % 8], 1e-4f) << c.label;
      }
    }
  }
}

TEST(Sweep, BoundsHoldTheInside) {
  for (const PassageCase& c : passage_cases()) {
    RandomStream random(RandomKey(16).at(c.label));
    const Box3d& box = c.field.bounds();
    const double growth = c.field.node()->traits().growth_rate();
    EXPECT_GT(growth, 0.2) << c.label;
    for (int i = 0; i < 3000; ++i) {
      const Vec3d p = box.center() + 0.8 * box.size() * random_vector(random, 1);
      double away2 = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double off = std::max({box.min[axis] - p[axis], p[axis] - box.max[axis], 0.0});
        away2 += off * off;
      }
      if (away2 > 0) {
        ASSERT_GE(c.field.value(p), growth * std::sqrt(away2) - 1e-9) << c.label << " at " << p;
      }
    }
  }
}

TEST(Sweep, NothingIsEverNaN) {
  const double nasty[] = {0.0, 5e-324, 1e-20, 0.5, -1, 1e6, -1e6};
  for (const PassageCase& c : passage_cases())
    for (const double x : nasty)
      for (const double y : nasty)
        for (const double z : nasty) {
          const field::Gradient g = c.field.gradient({x, y, z});
          ASSERT_TRUE(std::isfinite(g.value) && std::isfinite(g.gradient.length())) << c.label;
        }
}

TEST(Sweep, NoSegmentsAreRefused) { EXPECT_THROW(sweep({}), Error); }

}  // namespace
}  // namespace vug::passages
