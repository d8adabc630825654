// SPDX-License-Identifier: Apache-2.0
#include "stands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::flora {
namespace {

double nearest_pair(const std::vector<Vec2d>& points) {
  double nearest = kInfinity;
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t j = 0; j < i; ++j) nearest = std::min(nearest, (points[i] - points[j]).length());
  return nearest;
}

TEST(PoissonDisk, KeepsTheDistanceAndIsMaximal) {
  const Corners bent = {{0, 0}, {30, 0}, {30, 15}, {15, 15}, {15, 30}, {0, 30}};
  const Plot plot(bent);
  const double r = 0.8;
  const std::vector<Vec2d> points = draw("poisson_disk", {{"distance", r}}, bent, 0);
  EXPECT_GE(nearest_pair(points), r * (1 - 1e-12));
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 20000; ++i) {
    const Vec2d p = plot.point(random);
    const bool covered = std::any_of(points.begin(), points.end(),
                                     [&](const Vec2d& q) { return (q - p).length() < r; });
    ASSERT_TRUE(covered) << to_string(p);
  }
}

// Random sequential disks of diameter r jam at a coverage of 0.5471 of the plane.
TEST(PoissonDisk, JamsAtTheDensityOfRandomSequentialDisks) {
  const double r = 1, side = 150;
  const auto count =
      static_cast<double>(draw("poisson_disk", {{"distance", r}}, square(side), 0).size());
  // Disks at the border extend outside: the plot is about half a distance wider.
  const double cover = count * kPi * r * r / 4 / ((side + r / 2) * (side + r / 2));
  EXPECT_NEAR(cover, 0.5471, 0.005);
}

TEST(PoissonDisk, StopsAtADensityAndRejectsImpossibleOnes) {
  const std::vector<Vec2d> points = draw("poisson_disk", {{"distance", 0.5}}, square(20), 1.5);
  EXPECT_EQ(points.size(), 600u);
  EXPECT_GE(nearest_pair(points), 0.5 * (1 - 1e-12));
  const std::string fault = fault_of("poisson_disk", {{"distance", 1.0}}, square(20), 1.5);
  EXPECT_NE(fault.find("600 plants 1 m apart do not fit: the plot only takes "), std::string::npos)
      << fault;
  EXPECT_NE(fault_of("poisson_disk", {{"distance", 1e-6}}, square(100), 0), "");
}

TEST(PoissonDisk, APlotSmallerThanTheDistanceHoldsOne) {
  EXPECT_EQ(draw("poisson_disk", {{"distance", 5.0}}, square(1), 0).size(), 1u);
}

}  // namespace
}  // namespace vug::flora
