// SPDX-License-Identifier: Apache-2.0
// Cluster processes compared with their theoretical K functions.
#include "stands.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vug::flora {
namespace {

constexpr double kSide = 20, kDensity = 2, kPerClump = 8;
constexpr double kClumps = kDensity / kPerClump;
constexpr int kRuns = 200;
const std::vector<double> kRadii = {0.25, 0.5, 1, 1.5, 2};

/// A plot, and a window in it whose distance from the border is the largest radius.
struct Window {
  Corners plot;
  Vec2d from, to;  ///< Corners of the window.
};
const Window kSquareWindow{square(kSide), {2, 2}, {kSide - 2, kSide - 2}};
/// Concave at (12, 12).
const Window kBentWindow{
    {{0, 0}, {24, 0}, {24, 12}, {12, 12}, {12, 24}, {0, 24}}, {2, 2}, {10, 22}};

/// Ripley's K with the known density, over all runs: the number of other points within r of a point
/// of the window, all of which are inside the plot.
std::vector<double> k_function(const std::string& name, const NamedValues& parameters,
                               const Window& window = kSquareWindow) {
  std::vector<double> pairs(kRadii.size());
  for (uint64_t run = 0; run < kRuns; ++run) {
    const std::vector<Vec2d> points = draw(name, parameters, window.plot, kDensity, run);
    for (const Vec2d& p : points) {
      if (p.x < window.from.x || p.y < window.from.y || p.x > window.to.x || p.y > window.to.y)
        continue;
      for (const Vec2d& other : points) {
        if (&other == &p) continue;
        const double apart = (other - p).length();
        for (size_t i = 0; i < kRadii.size(); ++i) pairs[i] += apart < kRadii[i];
      }
    }
  }
  const Vec2d inner = window.to - window.from;
  for (double& k : pairs) k /= kRuns * inner.x * inner.y * kDensity * kDensity;
  return pairs;
}

TEST(Clusters, ThomasHasItsTheoreticalKFunction) {
  const double spread = 0.5;
  const auto found = k_function("thomas", {{"per_clump", kPerClump}, {"spread", spread}});
  for (size_t i = 0; i < kRadii.size(); ++i) {
    const double r = kRadii[i];
    const double theory = kPi * r * r + (1 - std::exp(-r * r / (4 * spread * spread))) / kClumps;
    EXPECT_NEAR(found[i] / theory, 1, 0.05) << "within " << r << " m";
  }
}

TEST(Clusters, KeepTheirKFunctionInAConcavePlot) {
  const double spread = 0.35, per_clump = 4, clumps = kDensity / per_clump;
  const auto found =
      k_function("thomas", {{"per_clump", per_clump}, {"spread", spread}}, kBentWindow);
  for (size_t i = 0; i < kRadii.size(); ++i) {
    const double r = kRadii[i];
    const double theory = kPi * r * r + (1 - std::exp(-r * r / (4 * spread * spread))) / clumps;
    EXPECT_NEAR(found[i] / theory, 1, 0.05) << "within " << r << " m";
  }
}

/// Probability that two uniform points of a disk are closer than z times its diameter.
double chance_in_disk(double z) {
  if (z >= 1) return 1;
  const double rest = std::sqrt(1 - z * z);
  return 2 + ((8 * z * z - 4) * std::acos(z) - 2 * std::asin(z) + 4 * z * rest * rest * rest -
              6 * z * rest) /
                 kPi;
}

TEST(Clusters, MaternHasItsTheoreticalKFunction) {
  const double radius = 0.9;
  const auto found = k_function("matern", {{"per_clump", kPerClump}, {"radius", radius}});
  for (size_t i = 0; i < kRadii.size(); ++i) {
    const double r = kRadii[i];
    const double theory = kPi * r * r + chance_in_disk(r / (2 * radius)) / kClumps;
    EXPECT_NEAR(found[i] / theory, 1, 0.05) << "within " << r << " m";
  }
}

TEST(Clusters, HaveNoEdgeEffect) {
  for (const char* name : {"thomas", "matern"}) {
    double at_border = 0, all = 0;
    const double border = 1;
    for (uint64_t run = 0; run < kRuns; ++run)
      for (const Vec2d& p : draw(name, {}, square(kSide), kDensity, run)) {
        ++all;
        at_border += std::min(std::min(p.x, p.y), std::min(kSide - p.x, kSide - p.y)) < border;
      }
    const double area = kSide * kSide, strip = area - (kSide - 2 * border) * (kSide - 2 * border);
    EXPECT_NEAR(all / kRuns / area / kDensity, 1, 0.05) << name;
    EXPECT_NEAR(at_border / all / (strip / area), 1, 0.05) << name;
  }
}

TEST(Clusters, HigherDensityKeepsExistingPoints) {
  const std::vector<Vec2d> few = draw("thomas", {}, square(30), 0.3);
  const std::vector<Vec2d> more = draw("thomas", {}, square(30), 0.6);
  ASSERT_GT(more.size(), few.size());
  EXPECT_TRUE(std::equal(few.begin(), few.end(), more.begin()));
}

}  // namespace
}  // namespace vug::flora
