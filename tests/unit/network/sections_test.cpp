// SPDX-License-Identifier: Apache-2.0
#include "graphs.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/section_statistics.h>

#include <cmath>

namespace vug::network {
namespace {

Network line(int stations, double leg) {
  Network network;
  std::vector<Vec3d> points;
  for (int i = 0; i < stations; ++i) points.emplace_back(leg * i, 0, 0);
  add_chain(network, points);
  return network;
}

/// The mean of the summaries of several drawings, in which the error of one along a correlated line
/// is small.
SectionSummary mean_summary(const Network& network, const SectionModel& model, int drawings) {
  SectionSummary mean;
  for (int seed = 0; seed < drawings; ++seed) {
    const SectionSummary s =
        measure_sections(draw_sections(network, model, static_cast<uint64_t>(seed)));
    mean.count = s.count;
    for (double SectionSummary::*member :
         {&SectionSummary::width_median, &SectionSummary::width_spread,
          &SectionSummary::height_median, &SectionSummary::height_spread,
          &SectionSummary::correlation, &SectionSummary::width_lag, &SectionSummary::height_lag,
          &SectionSummary::off_centre_width, &SectionSummary::off_centre_height})
      mean.*member += s.*member / drawings;
  }
  return mean;
}

TEST(Sections, HaveTheStatisticsOfTheirModel) {
  const double leg = 8;
  const Network network = line(5000, leg);
  const double lag = 0.7 * std::exp(-3 * leg / 50);  // The variogram's correlation at one leg.
  for (const NamedSectionModel& named : section_models()) {
    const SectionModel& model = named.model;
    const SectionSummary s = mean_summary(network, model, 4);
    EXPECT_EQ(s.count, 5000);
    EXPECT_NEAR(s.width_median / model.width_median, 1, 0.05) << named.name;
    EXPECT_NEAR(s.height_median / model.height_median, 1, 0.05) << named.name;
    EXPECT_NEAR(s.width_spread, model.width_spread, 0.05) << named.name;
    EXPECT_NEAR(s.height_spread, model.height_spread, 0.05) << named.name;
    EXPECT_NEAR(s.correlation, model.correlation, 0.05) << named.name;
    EXPECT_NEAR(s.width_lag, lag, 0.05) << named.name;
    EXPECT_NEAR(s.height_lag, lag, 0.05) << named.name;
    EXPECT_NEAR(s.off_centre_width, model.off_centre_width, 0.02) << named.name;
    EXPECT_NEAR(s.off_centre_height, model.off_centre_height, 0.02) << named.name;
  }
}

TEST(Sections, CorrelationFallsWithTheLengthOfLegs) {
  const SectionModel model;
  double before = 1;
  for (const double leg : {2.0, 8.0, 16.0, 60.0}) {
    const SectionSummary s = mean_summary(line(4000, leg), model, 3);
    EXPECT_NEAR(s.width_lag, 0.7 * std::exp(-3 * leg / 50), 0.05) << leg;
    EXPECT_LT(s.width_lag, before);
    before = s.width_lag;
  }
}

TEST(Sections, MeasuredSectionsRemainAndGuideTheirNeighbours) {
  SectionModel model;
  model.nugget = 0.1;
  double sum = 0;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    Network network = line(3, 2);
    network.stations[1].section = CrossSection{20, 20, 1, 1};
    const Network drawn = draw_sections(network, model, seed);
    EXPECT_EQ(drawn.stations[1].section->left, 20.0);
    const CrossSection& next = *drawn.stations[2].section;
    sum += std::log(*next.left + *next.right);
  }
  // The expectation is (1 - nugget) exp(-3 d / range) of the way from the mean to the measurement.
  const double expected =
      std::log(1.25) + 0.9 * std::exp(-6.0 / 50) * (std::log(40) - std::log(1.25));
  EXPECT_NEAR(sum / 200, expected, 0.1);
}

TEST(Sections, ReachEveryStation) {
  Network network = line(4, 5);
  add_leg(network, 3, 0);
  network.stations.push_back({.position = Vec3d(100, 0, 0)});
  for (const Station& station : draw_sections(network, {}, 1).stations) {
    ASSERT_TRUE(station.section);
    EXPECT_GE(*station.section->left, 0);
    EXPECT_GE(*station.section->down, 0);
  }
}

TEST(Sections, AreAtLeastAsLargeAsTheModelSays) {
  Network network;
  std::vector<Vec3d> line;
  for (int i = 0; i < 400; ++i) line.emplace_back(6.0 * i, 0, 0);
  add_chain(network, line);
  SectionModel model;
  const Network usual = draw_sections(network, model, 4);
  model.least_width = 0.8;
  model.least_height = 1.5;
  const Network roomy = draw_sections(network, model, 4);
  int raised = 0;
  for (size_t i = 0; i < usual.stations.size(); ++i) {
    const CrossSection &a = *usual.stations[i].section, &b = *roomy.stations[i].section;
    const double width = *a.left + *a.right, height = *a.up + *a.down;
    EXPECT_NEAR(*b.left + *b.right, std::max(width, 0.8), 1e-12);
    EXPECT_NEAR(*b.up + *b.down, std::max(height, 1.5), 1e-12);
    raised += width < 0.8 || height < 1.5;
  }
  EXPECT_GT(raised, 100) << "the model has narrow places";
}

TEST(Sections, RejectInvalidModels) {
  const Network network = line(2, 1);
  for (double SectionModel::*member :
       {&SectionModel::width_median, &SectionModel::height_median, &SectionModel::width_spread,
        &SectionModel::nugget, &SectionModel::range, &SectionModel::correlation,
        &SectionModel::off_centre_width, &SectionModel::off_centre_height})
    for (const double value : {std::nan(""), -2.0, kInfinity}) {
      SectionModel model;
      model.*member = value;
      EXPECT_THROW(draw_sections(network, model, 1), Error) << value;
    }
}

TEST(Sections, SummariesIgnoreIncompleteStations) {
  Network network = line(3, 1);
  network.stations[0].section = CrossSection{1, 1, 1, {}};
  network.stations[1].section = CrossSection{0, 2, 1, 3};
  const SectionSummary s = measure_sections(network);
  EXPECT_EQ(s.count, 1);
  EXPECT_DOUBLE_EQ(s.width_median, 2);
  EXPECT_DOUBLE_EQ(s.height_median, 4);
  EXPECT_DOUBLE_EQ(s.off_centre_width, 1);
  EXPECT_DOUBLE_EQ(s.off_centre_height, 0.5);
  EXPECT_TRUE(std::isnan(s.width_spread));
  EXPECT_TRUE(std::isnan(measure_sections({}).width_median));
}

}  // namespace
}  // namespace vug::network
