// SPDX-License-Identifier: Apache-2.0
// The choice of different shots.
#include "synthetic.h"

#include <gtest/gtest.h>
#include <vug/scout/choose.h>

#include <algorithm>
#include <cmath>

namespace vug::scout {
namespace {

Rated rated(double score, double x, double azimuth = 0, Framing framing = Framing::normal) {
  Rated out;
  out.candidate = {{Vec3d(x, 1.6, 0), azimuth, 0, 1}, framing};
  out.score = score;
  out.shares = {{0, 1.0}};
  return out;
}

TEST(Choose, SimilarityFallsWithDistanceAngleAndContent) {
  const Rated a = rated(1, 0);
  EXPECT_EQ(similarity(a, a), 1);
  EXPECT_NEAR(similarity(a, rated(1, 8)), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(similarity(a, rated(1, 0, 40 * kDegree)), std::exp(-1.0), 1e-12);
  EXPECT_NEAR(similarity(a, rated(1, 0, (360 - 40) * kDegree)), std::exp(-1.0), 1e-9);
  Rated half = a;
  half.shares = {{0, 0.5}, {1, 0.5}};
  EXPECT_EQ(similarity(a, half), 0.5);
}

TEST(Choose, ATwinIsWorthLessThanAnotherView) {
  const std::vector<Rated> all = {rated(1, 0), rated(0.95, 0.1), rated(0.5, 40), rated(0, 80)};
  EXPECT_EQ(choose_shots(all, 1), (std::vector<size_t>{0}));
  EXPECT_EQ(choose_shots(all, 2), (std::vector<size_t>{0, 2}));
  EXPECT_EQ(choose_shots(all, 9), (std::vector<size_t>{0, 1, 2})) << "best first, and none of 0";
  EXPECT_TRUE(choose_shots({rated(0, 0)}, 3).empty());
}

TEST(Choose, ASheetHasAllFramings) {
  std::vector<Rated> all;
  for (int i = 0; i < 20; ++i) all.push_back(rated(1 - 0.001 * i, 40.0 * i));
  for (int i = 0; i < 3; ++i)
    for (const Framing framing : {Framing::wide, Framing::low, Framing::close, Framing::up})
      all.push_back(rated(0.6, 1000 + 40.0 * static_cast<double>(all.size()), 0, framing));
  const auto count = [&](const std::vector<size_t>& chosen, Framing framing) {
    return std::count_if(chosen.begin(), chosen.end(),
                         [&](size_t i) { return all[i].candidate.framing == framing; });
  };
  const std::vector<size_t> chosen = choose_shots(all, 12);
  EXPECT_EQ(chosen.size(), 12u);
  EXPECT_EQ(count(chosen, Framing::wide), 2);
  EXPECT_EQ(count(chosen, Framing::low), 2);
  EXPECT_EQ(count(chosen, Framing::close), 2);
  EXPECT_EQ(count(chosen, Framing::up), 1);
  EXPECT_EQ(chosen.front(), 0u);
  for (Rated& each : all)
    if (each.candidate.framing != Framing::normal) each.score = 0.4;
  EXPECT_EQ(count(choose_shots(all, 12), Framing::normal), 12) << "below half of the best score";
}

}  // namespace
}  // namespace vug::scout
