// SPDX-License-Identifier: Apache-2.0
// Rimstone pools: level crests at the law's distances, and water up to their lips.
#include <vug/base/rng.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/rimstone_params.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::field {
namespace {

constexpr double kHeight = 0.1;

Field floor_of(double degrees) {
  return make("half_space", {{"normal", Vec3d(std::tan(degrees * kPi / 180), 1, 0)}});
}

/// Heights of the highest surface at equal distances along x, downhill.
std::vector<double> profile(const Field& field, double degrees, double z, double step, int count) {
  std::vector<double> out;
  for (int i = 0; i < count; ++i) {
    const double x = step * i, smooth = -x * std::tan(degrees * kPi / 180);
    double y = smooth + 2 * kHeight;
    const auto air = [&](double height) { return field.value({x, height, z}) > 0; };
    while (air(y) && y > smooth - 4 * kHeight) y -= 0.05 * kHeight;
    double above = y + 0.05 * kHeight;
    for (int k = 0; k < 12; ++k) (air(0.5 * (y + above)) ? above : y) = 0.5 * (y + above);
    out.push_back(y);
  }
  return out;
}

/// Indices of crests: the surface is lower on both sides.
std::vector<size_t> crests(const std::vector<double>& y) {
  std::vector<size_t> out;
  for (size_t i = 3; i + 3 < y.size(); ++i)
    if (y[i] >= *std::max_element(y.begin() + static_cast<std::ptrdiff_t>(i) - 3,
                                  y.begin() + static_cast<std::ptrdiff_t>(i) + 4) &&
        y[i] > y[i - 3] + 0.002 * kHeight && (out.empty() || i > out.back() + 3))
      out.push_back(i);
  return out;
}

RimstoneParams params(double degrees, double lobes) {
  return {.field = floor_of(degrees), .height = kHeight, .lobes = lobes};
}

TEST(Terrace, IsContinuousWithCrestsAtWholeNumbers) {
  for (const double depth : {0.3, 0.5, 0.8}) {
    for (int k = -3; k < 4; ++k) {
      EXPECT_NEAR(terrace(k + 0.0, depth), k, 1e-12);
      EXPECT_NEAR(terrace(k + 1 - 1e-9, depth), k + 1, 1e-6);
      EXPECT_NEAR(terrace(k + 0.5, depth), k - depth, 1e-12);
    }
    for (double u = -2; u < 2; u += 0.003) {
      EXPECT_LT(std::fabs(terrace(u + 0.001, depth) - terrace(u, depth)),
                0.001 * 6.1 * (1 + depth));
      EXPECT_LT(std::fabs(terrace_water(u + 0.001, depth) - terrace_water(u, depth)), 0.011);
      const bool wet = terrace_water(u, depth) > terrace(u, depth) + 1e-9;
      if (wet) {
        EXPECT_EQ(terrace_water(u, depth), std::floor(u)) << "level up to the lip";
      }
    }
  }
}

TEST(Rimstone, CrestsAreLevelAndApartByTheLaw) {
  for (const double degrees : {5.0, 10.0, 15.0, 20.0}) {
    const double apart = kHeight / std::tan(degrees * kPi / 180), step = apart / 150;
    const std::vector<double> y = profile(rimstone(params(degrees, 0)), degrees, 0, step, 700);
    const std::vector<size_t> found = crests(y);
    ASSERT_GE(found.size(), 3u) << degrees;
    for (size_t i = 0; i < found.size(); ++i) {
      const double level = y[found[i]] / kHeight;
      EXPECT_NEAR(level, std::round(level), 0.02) << degrees;
      if (i > 0) {
        EXPECT_NEAR(step * static_cast<double>(found[i] - found[i - 1]), apart, 0.1 * apart);
      }
    }
  }
}

TEST(Rimstone, CrestsOfLobesAreLevelToo) {
  const Field stone = rimstone(params(10, 0.3));
  for (const double z : {0.0, 0.23, 0.71, 1.3}) {
    const std::vector<double> y = profile(stone, 10, z, 0.004, 700);
    for (const size_t i : crests(y))
      EXPECT_NEAR(y[i] / kHeight, std::round(y[i] / kHeight), 0.03) << z;
  }
}

TEST(Rimstone, DamsAreSteeperDownstream) {
  const double degrees = 10, step = kHeight / std::tan(degrees * kPi / 180) / 300;
  const std::vector<double> y = profile(rimstone(params(degrees, 0)), degrees, 0, step, 1200);
  for (const size_t i : crests(y)) {
    double up = 0, down = 0;
    for (size_t k = 1; k < 100 && i + k < y.size() && i >= k; ++k) {
      up = std::max(up, y[i - k + 1] - y[i - k]);
      down = std::max(down, y[i + k - 1] - y[i + k]);
    }
    EXPECT_GT(down, 1.2 * up);
  }
}

TEST(RimstoneWater, StandsToTheLipsAndNeverAboveThem) {
  const double degrees = 8;
  for (const double lobes : {0.0, 0.3}) {
    const Field stone = rimstone(params(degrees, lobes)),
                water = rimstone_water(params(degrees, lobes));
    for (const double z : {0.0, 0.4}) {
      const std::vector<double> rock = profile(stone, degrees, z, 0.005, 600),
                                surface = profile(water, degrees, z, 0.005, 600);
      int wet = 0;
      for (size_t i = 0; i < rock.size(); ++i) {
        if (surface[i] < rock[i] + 0.02 * kHeight) continue;
        ++wet;
        const double level = surface[i] / kHeight;
        EXPECT_NEAR(level, std::round(level), 0.02);
        // The nearest crest downstream is not lower.
        const auto end = rock.begin() + static_cast<std::ptrdiff_t>(std::min(i + 200, rock.size()));
        const double lip = *std::max_element(rock.begin() + static_cast<std::ptrdiff_t>(i), end);
        if (i + 200 < rock.size()) {
          EXPECT_LT(surface[i], lip + 0.02 * kHeight);
        }
      }
      EXPECT_GT(wet, 200);
    }
  }
}

TEST(Crenulation, HasLevelCrestsAtItsWavelengthThatAreSteeperBelow) {
  const Noise noise = make_noise("crenulation", {{"wavelength", 0.01}, {"wander", 0.5}});
  int crests = 0;
  double steepest_up = 0, steepest_down = 0;
  constexpr double kStep = 1e-4;
  for (int i = 1; i < 10000; ++i) {
    const double y = kStep * i, v = noise.field.value({0.3, y, 0.1});
    const double before = noise.field.value({0.3, y - kStep, 0.1}),
                 after = noise.field.value({0.3, y + kStep, 0.1});
    EXPECT_LE(std::fabs(v), 1 + 1e-9);
    crests += v > before && v >= after;
    steepest_up = std::max(steepest_up, v - before);
    steepest_down = std::max(steepest_down, before - v);
  }
  EXPECT_NEAR(crests, 100, 10);
  EXPECT_GT(steepest_up, 1.5 * steepest_down) << "the lower side of a crest is steeper";
}

TEST(Crenulation, IsLevelWithoutWander) {
  const Noise noise = make_noise("crenulation", {{"wander", 0.0}});
  for (const double x : {0.1, 2.0, -3.3})
    EXPECT_NEAR(noise.field.value({x, 0.123, 0.4}), noise.field.value({0, 0.123, 0}), 1e-12);
}

TEST(Rimstone, LeavesWallsAndRoofsAsTheyAre) {
  RimstoneParams p = params(0, 0.3);
  p.field = make("sphere", {{"radius", 2.0}});
  const Field stone = rimstone(p);
  RandomStream random(RandomKey(9));
  for (int i = 0; i < 300; ++i) {
    const double angle = random.uniform(0, 2 * kPi), up = random.uniform(-1, 0.4);
    const double across = std::sqrt(1 - up * up);
    const Vec3d q = Vec3d(across * std::cos(angle), up, across * std::sin(angle)) * 2.1;
    EXPECT_NEAR(stone.value(q), p.field.value(q), 1e-9);
  }
}

}  // namespace
}  // namespace vug::field
