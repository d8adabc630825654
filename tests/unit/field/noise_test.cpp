// SPDX-License-Identifier: Apache-2.0
// Every noise: its bounds, slopes and evaluation modes; the statistics of gradient noise.
#include <vug/base/rng.h>
#include <vug/field/lattice.h>
#include <vug/field/noise.h>

#include "rocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

Vec3d random_float_point(RandomStream& random, double reach) {
  return Vec3d(Vec3f(Vec3d(random.uniform(-reach, reach), random.uniform(-reach, reach),
                           random.uniform(-reach, reach))));
}

class EachNoise : public testing::TestWithParam<const NoiseKind*> {
 protected:
  /// With defaults, or of rocks with materials if it needs a field.
  Noise noise() const {
    if (const auto with_defaults = default_noise(GetParam()->info.name)) return *with_defaults;
    const auto& params = GetParam()->info.params;
    const auto field =
        std::find_if(params.begin(), params.end(), [](const auto& each) { return each.required; });
    return make_noise(GetParam()->info.name, {{field->name, as_value(two_rocks(0.2))}});
  }
};

TEST_P(EachNoise, StaysInItsRangeAndBelowItsSlope) {
  const Noise n = noise();
  RandomStream random(RandomKey(11));
  double least = 1e9, most = -1e9;
  for (int i = 0; i < 20000; ++i) {
    const Vec3d p = random_float_point(random, 50);
    const Vec3d q = p + random_float_point(random, std::pow(10.0, random.uniform(-4, 0)));
    const double a = n.field.value(p), b = n.field.value(q);
    least = std::min(least, a);
    most = std::max(most, a);
    ASSERT_TRUE(n.range.contains(a));
    ASSERT_LE(std::fabs(a - b), n.field.lipschitz() * (p - q).length() * (1 + 1e-9) + 1e-12);
  }
  EXPECT_GT(most - least, 0.5);  // Excludes a constant.
}

TEST_P(EachNoise, BoundsOverBallsAndBoxesHold) {
  const Noise n = noise();
  RandomStream random(RandomKey(12));
  for (int i = 0; i < 300; ++i) {
    const Ball ball{random_float_point(random, 20), std::pow(10.0, random.uniform(-3, 0.5))};
    const Interval range = n.field.restricted(ball).range;
    const Vec3d corner(ball.radius / std::sqrt(3.0));
    const Interval box = n.field.interval({ball.centre - corner, ball.centre + corner});
    for (int k = 0; k < 30; ++k) {
      const double value =
          n.field.value(ball.centre + random_float_point(random, ball.radius / std::sqrt(3.0)));
      ASSERT_TRUE(range.contains(value));
      ASSERT_TRUE(box.contains(value));
    }
  }
}

TEST_P(EachNoise, GradientIsTheLimitOfDifferences) {
  const Noise n = noise();
  RandomStream random(RandomKey(13));
  int creases = 0;
  for (int i = 0; i < 500; ++i) {
    const Vec3d p = random_float_point(random, 20);
    const Gradient g = n.field.gradient(p);
    EXPECT_NEAR(g.value, n.field.value(p), 1e-12);
    for (int axis = 0; axis < 3; ++axis) {
      Vec3d step(0);
      step[axis] = 1e-6;
      const double slope = (n.field.value(p + step) - n.field.value(p - step)) / 2e-6;
      if (std::fabs(slope - g.gradient[axis]) > 1e-3 * (1 + n.field.lipschitz())) ++creases;
    }
  }
  EXPECT_LE(creases, 3);  // A finite difference may straddle a crease, once in thousands.
}

TEST_P(EachNoise, BatchesAgreeWithScalars) {
  const Noise n = noise();
  RandomStream random(RandomKey(14));
  std::vector<Vec3f> points;
  for (int i = 0; i < 3001; ++i) points.push_back(Vec3f(random_float_point(random, 20)));
  const std::vector<float> values = sample(n.field, points);
  // Coordinates in cells are rounded to a relative 2^-24 before the lattice lookup.
  const double allowed = 4e-6 * n.field.lipschitz() + 2e-6;
  for (size_t i = 0; i < points.size(); ++i)
    ASSERT_NEAR(values[i], n.field.value(Vec3d(points[i])), allowed);
}

TEST(DistanceRamp, IsLinearBetweenItsDistances) {
  const auto ramp = [](double from, double to) {
    return make_noise(
        "distance_ramp",
        {{"field", as_value(make("sphere", {{"radius", 2}}))}, {"from", from}, {"to", to}});
  };
  const Noise away = ramp(1, 3), near = ramp(3, 1);
  for (const auto& [x, value] :
       {std::pair(0.0, -1.0), {3.0, -1.0}, {3.5, -0.5}, {4.0, 0.0}, {6.0, 1.0}}) {
    EXPECT_DOUBLE_EQ(away.field.value({x, 0, 0}), value);
    EXPECT_DOUBLE_EQ(near.field.value({x, 0, 0}), -value);
  }
  EXPECT_DOUBLE_EQ(away.field.lipschitz(), 1);
  EXPECT_THROW(ramp(1, 1), Error);
}

INSTANTIATE_TEST_SUITE_P(Registry, EachNoise, testing::ValuesIn(noises()),
                         [](const auto& kind) { return kind.param->info.name; });

struct Moments {
  double mean = 0, deviation = 0;
};
template <class Function>
Moments moments(int count, const Function& value) {
  double sum = 0, squares = 0;
  for (int i = 0; i < count; ++i) {
    const double v = value(i);
    sum += v;
    squares += v * v;
  }
  return {sum / count, std::sqrt(squares / count - sum * sum / count / count)};
}

TEST(Noise, GradientNoiseHasMeanZeroAndDeviationOneThird) {
  // 40,000 nearly independent values: the mean is within 5 / 3 / sqrt(40000) of 0.
  RandomStream random(RandomKey(15));
  const Moments m = moments(
      40000, [&](int) { return gradient_noise(point(random_float_point(random, 1000)), 7); });
  EXPECT_NEAR(m.mean, 0, 0.0084);
  EXPECT_NEAR(m.deviation, 1.0 / 3, 0.01);
}

TEST(Noise, FbmHasTheSameDeviationForAnyOctaves) {
  for (const int octaves : {1, 3, 6}) {
    const Noise n = make_noise("fbm", {{"octaves", octaves}});
    RandomStream random(RandomKey(16));
    const Moments m =
        moments(20000, [&](int) { return n.field.value(random_float_point(random, 1000)); });
    EXPECT_NEAR(m.mean, 0, 0.012);
    EXPECT_NEAR(m.deviation, 1.0 / 3, 0.012);
  }
}

TEST(Noise, FbmIsIsotropicAndHomogeneous) {
  const Noise n = make_noise("fbm", {{"octaves", 4}});
  const Vec3d ways[] = {
      {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.6, 0.8, 0}, {0.57735, 0.57735, 0.57735}};
  double first = 0;
  for (const Vec3d& way : ways) {
    RandomStream random(RandomKey(17));
    const Moments m = moments(40000, [&](int) {
      const Vec3d p = random_float_point(random, 500);
      return n.field.value(p + 0.3 * way) - n.field.value(p);
    });
    if (first == 0) first = m.deviation;
    EXPECT_NEAR(m.deviation / first, 1, 0.02) << way;
  }
  RandomStream random(RandomKey(18));
  const Moments plane = moments(40000, [&](int) {
    Vec3d p = random_float_point(random, 500);
    p.y = std::floor(p.y);
    return n.field.value(p);
  });
  EXPECT_NEAR(plane.deviation, 1.0 / 3, 0.012);
}

TEST(Noise, SeedsAreIndependent) {
  const Noise a = make_noise("fbm", {{"seed", 1}}), b = make_noise("fbm", {{"seed", 2}});
  RandomStream random(RandomKey(19));
  double product = 0;
  for (int i = 0; i < 40000; ++i) {
    const Vec3d p = random_float_point(random, 1000);
    product += a.field.value(p) * b.field.value(p);
  }
  EXPECT_NEAR(product / 40000, 0, 5.0 / 9 / 200);
}

TEST(Noise, NearestSitesEqualBruteForce) {
  // Brute force: the sites of 7^3 cells, found by queries at many points near each.
  RandomStream random(RandomKey(20));
  for (int i = 0; i < 2000; ++i) {
    const Point<double> p = point(random_float_point(random, 30));
    const auto here = nearest_sites(p, 3);
    EXPECT_LE(here.first.squared, here.second.squared);
    const Vec3d site = vector(p) - vector(here.first.offset);
    for (int k = 0; k < 20; ++k) {  // No nearby query finds a site closer to p.
      const Vec3d q = vector(p) + random_float_point(random, 1.0);
      const Vec3d other = q - vector(nearest_sites(point(q), 3).first.offset);
      EXPECT_GE((other - vector(p)).length2(), here.first.squared - 1e-12);
      if ((other - site).length() > 1e-9) {
        EXPECT_GE((other - vector(p)).length2(), here.second.squared - 1e-12);
      }
    }
  }
}

}  // namespace
}  // namespace vug::field
