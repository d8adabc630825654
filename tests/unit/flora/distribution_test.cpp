// SPDX-License-Identifier: Apache-2.0
// Guarantees of all distributions, and the statistics of those without interaction.
#include "stands.h"

#include <gtest/gtest.h>
#include <vug/base/parallel.h>
#include <vug/flora/weighted_point.h>

#include <cmath>

namespace vug::flora {
namespace {

/// Pearson's statistic over 4 x 4 cells of a unit square against equal probabilities.
double chi_square(const std::vector<Vec2d>& points) {
  std::array<double, 16> in{};
  for (const Vec2d& p : points) {
    const auto cell = [](double x) { return std::min(3, static_cast<int>(4 * x)); };
    ++in[static_cast<size_t>(4 * cell(p.y) + cell(p.x))];
  }
  const double expected = static_cast<double>(points.size()) / 16;
  double sum = 0;
  for (const double count : in) sum += (count - expected) * (count - expected) / expected;
  return sum;
}

/// Share of the points in the polygon scaled by one half about the origin.
double share_in_half(const Corners& corners, const std::vector<Vec2d>& points) {
  Corners small = corners;
  for (Vec2d& corner : small) corner /= 2;
  const Plot half(small);
  double inside = 0;
  for (const Vec2d& p : points) inside += half.contains(p);
  return inside / static_cast<double>(points.size());
}

TEST(Distributions, ChiSquareAcceptsUniformAndRejectsThePaper) {
  constexpr double kOneInAThousand = 37.70;  // Chi-square with 15 degrees of freedom.
  for (const uint64_t seed : {1U, 2U, 3U})
    EXPECT_LT(chi_square(draw("uniform", {}, square(1), 10000, seed)), kOneInAThousand);
  EXPECT_GT(chi_square(draw("paper", {}, square(1), 10000)), 1000);
}

TEST(Distributions, AQuarterOfUniformPointsIsInTheHalfScalePolygon) {
  const double density = 1e6 / Plot(hexagon()).area();
  const std::vector<Vec2d> even = draw("uniform", {}, hexagon(), density);
  EXPECT_EQ(even.size(), 1000000u);
  EXPECT_NEAR(share_in_half(hexagon(), even), 0.25, 0.005);
  // The paper's points crowd in the middle.
  EXPECT_NEAR(share_in_half(hexagon(), draw("paper", {}, hexagon(), density / 10)), 0.95, 0.01);
}

TEST(Distributions, ThePapersPointIsTheWeightedMean) {
  const Vec2d p = weighted_point({{0, 0}, {4, 0}, {0, 8}}, {1, 2, 1});
  EXPECT_EQ(p, Vec2d(2, 2));
  for (const double weight : {0.0, -1.0, static_cast<double>(NAN), kInfinity})
    EXPECT_THROW(weighted_point({{0, 0}, {4, 0}, {0, 8}}, {1, weight, 1}), Error);
  EXPECT_THROW(weighted_point({{0, 0}, {4, 0}, {0, 8}}, {1, 1}), Error);
}

TEST(Distributions, ThePaperRejectsNegativeWeightsAndConcavePolygons) {
  const auto weights = [](double low, double high) {
    return NamedValues{{"weights", List{Value(low), Value(high)}}};
  };
  EXPECT_NE(fault_of("paper", weights(-1, 1), square(1), 10), "");
  EXPECT_NE(fault_of("paper", weights(0, 0), square(1), 10), "");
  EXPECT_EQ(fault_of("paper", weights(0.5, 1), square(1), 10), "");
  const Corners arrow = {{0, 0}, {2, 1}, {0, 2}, {1, 1}};
  EXPECT_NE(fault_of("paper", {}, arrow, 10).find("corner 4 at (1, 1) is concave"),
            std::string::npos);
}

// 0.825 stems per square metre: 1 / (2 sqrt(density)).
TEST(Distributions, PoissonStandHasTheoreticalNearestNeighbourDistances) {
  const double side = 100, density = 0.825, border = 5;
  const std::vector<Vec2d> points = draw("uniform", {{"exact", false}}, square(side), density);
  double sum = 0, count = 0;
  for (const Vec2d& p : points) {
    if (std::min(std::min(p.x, p.y), std::min(side - p.x, side - p.y)) < border) continue;
    double nearest = kInfinity;
    for (const Vec2d& other : points)
      if (&other != &p) nearest = std::min(nearest, (other - p).length2());
    sum += std::sqrt(nearest), ++count;
  }
  EXPECT_NEAR(sum / count, 0.551, 0.03 * 0.551);
}

TEST(Distributions, PoissonDeviatesHaveEqualMeanAndVariance) {
  for (const double mean : {0.3, 4.0, 900.0}) {
    constexpr int kCount = 20000;
    double sum = 0, squares = 0;
    RandomStream random(RandomKey(4));
    for (int i = 0; i < kCount; ++i) {
      const auto n = static_cast<double>(poisson(mean, random));
      sum += n, squares += n * n;
    }
    const double found = sum / kCount, variance = squares / kCount - found * found;
    EXPECT_NEAR(found, mean, 5 * std::sqrt(mean / kCount));
    EXPECT_NEAR(variance / mean, 1, 0.08);
  }
}

TEST(Distributions, AllStayInThePlotAndHaveTheRequestedNumber) {
  const Corners bent = {{0, 0}, {40, 0}, {40, 20}, {20, 20}, {20, 40}, {0, 40}};
  const Plot plot(bent);
  for (const DistributionKind* kind : distributions()) {
    const std::string& name = kind->info.name;
    const Corners& corners = name == "paper" ? square(35) : bent;
    double count = 0;
    for (uint64_t seed = 0; seed < 20; ++seed)
      for (const Vec2d& p : draw(name, {}, corners, 0.5, seed)) {
        ++count;
        ASSERT_TRUE(name == "paper" || plot.contains(p)) << name << to_string(p);
      }
    // About a hundred clumps of 12, twenty times.
    const double expected = 20 * 0.5 * Plot(corners).area();
    EXPECT_NEAR(count / expected, 1, 5 * std::sqrt(13 / expected)) << name;
  }
}

TEST(Distributions, DependOnTheKey) {
  for (const DistributionKind* kind : distributions()) {
    const std::string& name = kind->info.name;
    const std::vector<Vec2d> first = draw(name, {}, square(30), 0.4, 7);
    with_threads(3, [&] {
      EXPECT_EQ(draw(name, {}, square(30), 0.4, 7), first) << name;
      EXPECT_NE(draw(name, {}, square(30), 0.4, 8), first) << name;
    });
  }
}

TEST(Distributions, RejectInvalidDensities) {
  for (const DistributionKind* kind : distributions())
    for (const double density : {-1.0, static_cast<double>(NAN), kInfinity, 1e12})
      EXPECT_NE(fault_of(kind->info.name, {}, square(30), density), "") << kind->info.name;
  EXPECT_NE(fault_of("uniform", {}, square(30), 0), "");
  EXPECT_NE(fault_of("mixed", {{"shares", List{Value(1.0)}}}, square(30), 1), "");
  EXPECT_NE(fault_of("mixed", {{"shares", List{Value(0.0), Value(0.0)}}}, square(30), 1), "");
}

}  // namespace
}  // namespace vug::flora
