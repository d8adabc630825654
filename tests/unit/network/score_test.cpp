// SPDX-License-Identifier: Apache-2.0
#include "graphs.h"

#include <gtest/gtest.h>
#include <vug/network/score.h>

#include <cmath>

namespace vug::network {
namespace {

/// The measures of a cave in the middle of the distribution.
Metrics median_cave() {
  Metrics m;
  m.orientation_entropy = 0.981;
  m.branch_length = 55.6;
  m.length_entropy = 0.415;
  m.length_variation = 1.32;
  m.tortuosity = 1.268;
  m.degree = 2.125;
  m.degree_variation = 0.5;
  m.degree_correlation = -0.286;
  m.nodes = 100;
  m.edges = 106;
  m.path_length = 9.3;
  m.dominance = 0.436;
  return m;
}

TEST(Score, TheMedianCaveIsReal) {
  const Realism realism = score(median_cave());
  EXPECT_DOUBLE_EQ(realism.overall, 100);
  EXPECT_TRUE(realism.advice().empty());
  EXPECT_TRUE(realism.sections.empty());
  for (const CriterionScore& s : realism.network) EXPECT_NEAR(s.percentile, 0.5, 1e-9) << s.name;
}

TEST(Score, QuantilesIncreaseAndAreTheirOwnPercentiles) {
  for (const Criterion& c : criteria())
    for (size_t i = 0; i < 7; ++i) {
      EXPECT_NEAR(percentile(c, c.quantiles[i]), kQuantileFractions[i], 1e-12) << c.name;
      if (i == 0) continue;
      EXPECT_LT(c.quantiles[i - 1], c.quantiles[i]) << c.name;
      const double middle = (c.quantiles[i - 1] + c.quantiles[i]) / 2;
      EXPECT_NEAR(percentile(c, middle), (kQuantileFractions[i - 1] + kQuantileFractions[i]) / 2,
                  1e-12);
    }
}

TEST(Score, RegionsAreTheirOwnPercentiles) {
  for (const SectionCriterion& c : section_criteria()) {
    const auto count = static_cast<double>(c.regions.size());
    for (size_t i = 0; i < c.regions.size(); ++i)
      EXPECT_NEAR(percentile(c, c.regions[i]), (static_cast<double>(i) + 0.5) / count, 1e-12);
    EXPECT_EQ(percentile(c, c.lowest), 0);
    EXPECT_EQ(percentile(c, c.highest), 1);
    EXPECT_TRUE(std::isnan(percentile(c, kUndefined)));
    const RealRange real = range_of(c);
    EXPECT_LT(real.lowest, real.low) << c.name;
    EXPECT_LE(real.low, c.regions.front()) << c.name;
    EXPECT_NEAR(percentile(c, real.median), 0.5, 1e-12) << c.name;
    EXPECT_GE(real.high, c.regions.back()) << c.name;
    EXPECT_LT(real.high, real.highest) << c.name;
  }
}

TEST(Score, StraightLegsGetAdvice) {
  Metrics metrics = median_cave();
  metrics.tortuosity = 1.04;
  const Realism realism = score(metrics);
  ASSERT_EQ(realism.advice().size(), 1u);
  EXPECT_EQ(realism.advice()[0].rfind("the legs are too straight: tortuosity 1.04; real caves have "
                                      "1.18 to 1.4",
                                      0),
            0u)
      << realism.advice()[0];
  EXPECT_DOUBLE_EQ(realism.overall, 90);  // One of ten criteria has realism 0.
}

TEST(Score, FewBranchesGetNoAdvice) {
  Metrics metrics = median_cave();
  metrics.tortuosity = 1.04;
  metrics.edges = kFewestBranches - 1;
  EXPECT_TRUE(score(metrics).advice().empty());
}

TEST(Score, FallsLinearlyInTheTails) {
  Metrics metrics = median_cave();
  metrics.tortuosity = (1.121 + 1.183) / 2;
  EXPECT_NEAR(score(metrics).overall, 95, 1e-9);
  metrics.tortuosity = 1.415;
  EXPECT_NEAR(score(metrics).overall, 100, 1e-9);
}

TEST(Score, UndefinedMeasuresDoNotCount) {
  Metrics metrics = median_cave();
  metrics.tortuosity = kUndefined;
  EXPECT_DOUBLE_EQ(score(metrics).overall, 100);
  EXPECT_EQ(score(Network{}).overall, 0);
}

TEST(Score, SectionsHaveAWeightOfAFifth) {
  SectionSummary sections;
  sections.count = 10;
  const Realism realism = score(median_cave(), sections);  // All zero: only correlations are near.
  double sum = 0;
  for (const CriterionScore& s : realism.sections) sum += s.realism;
  EXPECT_NEAR(realism.overall, 80 + 20 * sum / 10, 1e-9);
  EXPECT_LT(sum, 1);
  EXPECT_EQ(realism.advice().size(), 10u);
}

TEST(Score, SectionsOfTheModelsAreReal) {
  Network network;
  std::vector<Vec3d> line;
  for (int i = 0; i < 3000; ++i) line.emplace_back(6.0 * i, 0, 0);
  add_chain(network, line);
  for (const NamedSectionModel& named : section_models()) {
    const Realism realism =
        score(median_cave(), measure_sections(draw_sections(network, named.model, 3)));
    EXPECT_GT(realism.overall, 96) << named.name;
  }
}

}  // namespace
}  // namespace vug::network
