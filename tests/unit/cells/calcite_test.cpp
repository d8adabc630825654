// SPDX-License-Identifier: Apache-2.0
// Calcite under films of water: the balance of calcium, closed forms, and the forms that emerge.
#include "slopes.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/cells/calcite.h>
#include <vug/drips/chemistry.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

constexpr CalciteOptions kCave{.equilibrium = 0.745, .rate = 1.335e-7};

CalciteRates rates_of(Simulation& s, double calcium, const CalciteOptions& options = kCave) {
  Pass pass(s, RandomKey(1), 0, nullptr);
  const FilmFlow flow(pass, FilmParams(), calcium);
  return calcite_rates(pass, flow, options);
}

TEST(Calcite, DepositsWhatTheWaterLoses) {
  for (const double calcium : {0.0, 0.2, 2.5}) {
    Simulation s(slope_network(0.6, 0.3, 0.01, 0.15), RandomKey(1));
    roughen(s, 0.08, 0.01);
    const CalciteRates rates = rates_of(s, calcium);
    const double lost = rates.balance.supplied - rates.balance.drained;
    EXPECT_NEAR(rates.balance.deposited / lost, 1, 1e-9) << calcium;
    EXPECT_EQ(rates.balance.deposited > 0, calcium > 0.745) << calcium;
    EXPECT_GT(std::fabs(lost), 0.01 * 1e-8) << calcium;
  }
}

TEST(Calcite, TheThicknessOfAStepContainsItsCalcium) {
  Simulation s(slope_network(0.6, 0.3, 0.01, 0.15), RandomKey(1));
  roughen(s, 0.08, 0.01);
  const CalciteRates rates = rates_of(
      s, 2, {.equilibrium = drips::equilibrium_calcium(10), .rate = drips::deposition_rate(10)});
  const std::vector<float> before = s.attributes().values<float>("height");
  // Short enough for one computation of the flow, and spread over neighbours.
  s.run({stage("calcite", {{"years", 0.05}, {"calcium", 2}, {"smooth", 0.01}})}, 1);
  double moles = 0, raised = 0;
  for (uint32_t i = 0; i < s.network().size(); ++i) {
    const auto area = static_cast<double>(s.network().area[i]);
    moles += area * static_cast<double>(s.attributes().values<float>("calcite")[i]) /
             drips::kCalciteVolume;
    raised += area * static_cast<double>(s.attributes().values<float>("height")[i] - before[i]);
  }
  const double expected = rates.balance.deposited * 0.05 * drips::kSecondsPerYear;
  EXPECT_NEAR(moles / expected, 1, 1e-4);
  EXPECT_NEAR(raised / drips::kCalciteVolume / expected, 1, 1e-3);
}

TEST(Calcite, FollowsTheClosedFormDownASlope) {
  const double c = 0.02, in = 2.2;
  const uint32_t across = 4, rows = 60;
  const auto n = std::make_shared<const Network>(slope_grid(across, rows, c, 0.5));
  Simulation s(n, RandomKey(1));
  auto& source = s.attributes().column<float>("source").now;
  std::fill(source.begin(), source.begin() + across, 1.0f);
  CalciteOptions options = kCave;
  options.rate = drips::deposition_rate(10), options.equilibrium = drips::equilibrium_calcium(10);
  options.agitation = 1e12;
  const CalciteRates rates = rates_of(s, in, options);
  const double discharge = c * c * FilmParams().rate / 86400;
  for (uint32_t i = 0; i < n->size(); ++i)
    ASSERT_NEAR(static_cast<double>(rates.concentration[i]),
                drips::calcium_after(in, 10, (1 + i / across) * c * c, discharge), 1e-5)
        << i;
  EXPECT_LT(rates.concentration.back(), 1);
}

TEST(Calcite, GrowsOnlyWhereWaterRuns) {
  Simulation s(slope_network(0.6, 0.3, 0.01, 0.3), RandomKey(1));
  auto& source = s.attributes().column<float>("source").now;
  for (uint32_t i = 0; i < source.size(); ++i)
    source[i] = s.network().position[i].x > 0.3f ? 1.0f : 0.0f;
  s.run({stage("calcite", {{"years", 1}, {"smooth", 0.01}})}, 3);
  const auto& calcite = s.attributes().values<float>("calcite");
  for (uint32_t i = 0; i < source.size(); ++i) {
    if (s.network().position[i].x < 0.28f) {
      ASSERT_EQ(calcite[i], 0) << i;
    }
    if (source[i] > 0) {
      ASSERT_GT(calcite[i], 0) << i;
    }
  }
}

TEST(Calcite, AggressiveWaterDissolvesSoftRock) {
  Simulation s(slope_network(0.6, 0.3, 0.01, 0.3), RandomKey(1));
  auto& hardness = s.attributes().column<float>("hardness").now;
  for (uint32_t i = 0; i < hardness.size(); ++i)
    hardness[i] = s.network().position[i].z > 0.15f ? 1.0f : 0.0f;
  // Condensed water contains no calcium.
  s.attributes().column<float>("source");
  s.run({stage("calcite", {{"years", 10}, {"condensation", 0.001}})}, 2);
  for (uint32_t i = 0; i < hardness.size(); ++i) {
    const float calcite = s.attributes().values<float>("calcite")[i];
    ASSERT_EQ(calcite < 0, hardness[i] == 0) << i;
    ASSERT_LE(s.attributes().values<float>("calcium")[i], 0.746f);
  }
}

/// The mean distance in metres of the crests of pools along lines down the slope.
double dam_spacing(const Simulation& s, double length, double width, double angle) {
  constexpr int kLines = 24;
  const Network& n = s.network();
  const auto& pool = s.attributes().values<float>("pool");
  double dams = 0;
  for (int line = 0; line < kLines; ++line) {
    const double z = width * (line + 0.5) / kLines;
    std::vector<std::pair<double, bool>> wet;
    for (uint32_t i = 0; i < n.size(); ++i)
      if (std::fabs(static_cast<double>(n.position[i].z) - z) < 0.6 * n.spacing)
        wet.emplace_back(static_cast<double>(n.position[i].x) / std::cos(angle), pool[i] > 3e-4f);
    std::sort(wet.begin(), wet.end());
    // A crest of at least two cells ends each pool.
    int dry = 0;
    bool in_pool = false;
    for (const auto& [down, is_wet] : wet) {
      dry = is_wet ? 0 : dry + 1;
      dams += is_wet && !in_pool ? 1.0 / kLines : 0;
      in_pool = is_wet || (in_pool && dry < 2);
    }
  }
  return length / dams;
}

TEST(Calcite, TheSpacingOfDamsIsLinearInTheCotangentOfTheSlope) {
  // Inter-dam distance = h / tan(slope) + k (hammer2010).
  constexpr double kDegree = kPi / 180, kLength = 0.9, kWidth = 0.15;
  std::vector<double> x, y;
  for (const double angle : {5 * kDegree, 10 * kDegree, 20 * kDegree}) {
    Simulation s(slope_network(kLength, kWidth, 0.005, angle), RandomKey(1));
    roughen(s, 0.03, 0.004);
    s.run({stage("calcite", {{"years", 1}, {"smooth", 0.005}})}, 100);
    x.push_back(1 / std::tan(angle));
    y.push_back(dam_spacing(s, kLength, kWidth, angle));
  }
  const double mx = (x[0] + x[1] + x[2]) / 3, my = (y[0] + y[1] + y[2]) / 3;
  double xx = 0, xy = 0, yy = 0;
  for (size_t k = 0; k < 3; ++k) {
    xx += (x[k] - mx) * (x[k] - mx);
    xy += (x[k] - mx) * (y[k] - my);
    yy += (y[k] - my) * (y[k] - my);
  }
  EXPECT_GT(xy * xy / (xx * yy), 0.8);
  // The height of the dams, in metres.
  EXPECT_GT(xy / xx, 0.003);
  EXPECT_LT(xy / xx, 0.04);
}

TEST(Calcite, CrestsGrowAndPoolsDeepen) {
  Simulation s(slope_network(0.5, 0.3, 0.005, 0.17), RandomKey(1));
  roughen(s, 0.03, 0.003);
  const std::vector<Stage> stages = {stage("calcite", {{"years", 1}, {"smooth", 0.005}})};
  s.run(stages, 1);
  const double water = total(s, "pool");
  s.run(stages, 25);
  EXPECT_GT(total(s, "pool"), 3 * water);
}

/// The mean square of the differences of `height` between neighbours across the slope, relative to
/// that between neighbours along it; the lower half of the slope only.
double grooves(const Simulation& s) {
  const Network& n = s.network();
  const auto& height = s.attributes().values<float>("height");
  double sum[2] = {0, 0}, count[2] = {0, 0};
  for (uint32_t i = 0; i < n.size(); ++i) {
    if (n.position[i].x < 0.15f) continue;
    for (const uint32_t j : n.links.of(i)) {
      const Vec3f d = n.position[j] - n.position[i];
      const float side = std::fabs(d.z) / d.length();
      if (side > 0.4f && side < 0.9f) continue;
      const int which = side > 0.5f ? 1 : 0;
      const auto step = static_cast<double>(height[j] - height[i]);
      sum[which] += step * step / static_cast<double>(d.length2());
      ++count[which];
    }
  }
  return sum[1] / count[1] / (sum[0] / count[0]);
}

TEST(Calcite, AggressiveWaterCutsFlutesDownTheSlope) {
  Simulation s(slope_network(0.5, 0.3, 0.004, 50 * kPi / 180), RandomKey(1));
  roughen(s, 0.03, 0.0005);
  const double before = grooves(s);
  s.run({stage("calcite", {{"years", 1}, {"rate", 0.05}, {"calcium", 0}, {"smooth", 0.004}})}, 60);
  EXPECT_GT(grooves(s), 2.5 * before);
}

TEST(Calcite, SameBytesForAnyNumberOfThreads) {
  const auto run = [](int threads) {
    return with_threads(threads, [] {
      Simulation s(slope_network(0.5, 0.3, 0.005, 0.17), RandomKey(1));
      roughen(s, 0.03, 0.003);
      s.run({stage("calcite", {{"years", 1}, {"smooth", 0.005}})}, 6);
      std::vector<float> all = s.attributes().values<float>("height");
      for (const char* name : {"film", "pool", "calcium", "discharge"})
        all.insert(all.end(), s.attributes().values<float>(name).begin(),
                   s.attributes().values<float>(name).end());
      return all;
    });
  };
  const std::vector<float> expected = run(1);
  EXPECT_EQ(run(2), expected);
  EXPECT_EQ(run(7), expected);
}

TEST(Calcite, RefusesImpossibleTimes) {
  Simulation s(slope_network(0.3, 0.2, 0.02, 0.3), RandomKey(1));
  const auto message = [&](double years) -> std::string {
    try {
      s.run({stage("calcite", {{"years", years}})}, 1);
    } catch (const Error& error) {
      return error.code() == ErrorCode::bad_input ? error.what() : "";
    }
    return "";
  };
  EXPECT_NE(message(-5), "");
  EXPECT_NE(message(0), "");
  EXPECT_NE(message(1e6).find("in a step of 1e+06 years"), std::string::npos);
  EXPECT_EQ(message(2), "");
}

}  // namespace
}  // namespace vug::cells
