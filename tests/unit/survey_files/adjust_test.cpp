// SPDX-License-Identifier: Apache-2.0
// Expected coordinates and misclosures are those of cavern 1.4.4 and of an independent dense
// least-squares solution.
#include "svx_text.h"

#include <vug/base/maths.h>
#include <vug/survey/adjust.h>
#include <vug/survey/statistics.h>

#include <fmt/format.h>

#include <cmath>

namespace vug::survey {
namespace {

TEST(Adjust, ALoopClosesByTheCovariancesOfItsLegs) {
  const Survey survey = read_svx_text(
                            "*fix 1 0 0 0\n1 2 10 90 0\n2 3 10 0 30\n*sd tape 0.2 metres\n"
                            "*sd compass 2 degrees\n3 4 10 270 0\n4 1 10 181 -28\n")
                            .survey;
  expect_near(position_of(survey, "2"), {10.0036, 0.0130, -0.0688}, 1e-4);
  expect_near(position_of(survey, "3"), {10.0106, 8.6983, 4.8695}, 1e-4);
  expect_near(position_of(survey, "4"), {0.0546, 8.8868, 4.8007}, 1e-4);
  ASSERT_EQ(survey.misclosures.size(), 1U);
  const Misclosure& misclosure = survey.misclosures[0];
  EXPECT_EQ(misclosure.stations, (std::vector<int>{0, 1, 2, 3, 0}));
  EXPECT_EQ(misclosure.legs, 4);
  EXPECT_DOUBLE_EQ(misclosure.length, 40);
  expect_near(misclosure.error, {-0.1541, -0.16788, 0.30528}, 1e-5);
  EXPECT_NEAR(misclosure.e, 0.638817, 1e-6);
  EXPECT_NEAR(misclosure.h, 0.405393, 1e-6);
  EXPECT_NEAR(misclosure.v, 1.533069, 1e-6);
}

TEST(Adjust, ANetworkOfLoopsIsSolvedAtOnce) {
  const Survey survey =
      read_svx_text(
          "*fix a 0 0 0\na b 12.00 80 5\nb c 15.00 10 -10\nc d 11.00 275 2\nd a 15.50 185 6\n"
          "b e 9.00 120 -20\ne f 14.00 25 -4\nf c 9.60 300 10\ne g 6.00 180 0\n")
          .survey;
  expect_near(position_of(survey, "b"), {11.5363, 1.3234, 1.0835}, 1e-4);
  expect_near(position_of(survey, "c"), {14.3634, 15.3868, -1.7401}, 1e-4);
  expect_near(position_of(survey, "d"), {3.0413, 15.5150, -1.4125}, 1e-4);
  expect_near(position_of(survey, "e"), {18.4815, -2.7713, -2.1668}, 1e-4);
  expect_near(position_of(survey, "f"), {22.9092, 10.5561, -3.2678}, 1e-4);
  expect_near(position_of(survey, "g"), {18.4815, -8.7713, -2.1668}, 1e-4);
  const double expected[4][3] = {{9.170525, 11.918874, 2.516700},
                                 {9.064724, 12.114091, 1.550516},
                                 {4.819069, 6.415733, 0.347421},
                                 {3.009671, 3.779070, 1.653009}};
  ASSERT_EQ(survey.misclosures.size(), 4U);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_NEAR(survey.misclosures[i].e, expected[i][0], 1e-6);
    EXPECT_NEAR(survey.misclosures[i].h, expected[i][1], 1e-6);
    EXPECT_NEAR(survey.misclosures[i].v, expected[i][2], 1e-6);
  }
}

/// A closed ring of legs with exact readings, of which one is changed.
std::string ring(int legs, int changed, double tape, double degrees) {
  std::string text = "*fix 0 0 0 0\n";
  for (int i = 0; i < legs; ++i)
    text +=
        fmt::format("{} {} {:.12f} {:.12f} 0\n", i, (i + 1) % legs, 10 + (i == changed ? tape : 0),
                    i * 360.0 / legs + (i == changed ? degrees : 0));
  return text;
}

TEST(Adjust, WrongReadingsAreBlunders) {
  EXPECT_TRUE(read_svx_text(ring(11, 5, 0, 0)).survey.blunders.empty());
  EXPECT_TRUE(read_svx_text(ring(11, 5, 0.05, 0.5)).survey.blunders.empty());

  const std::vector<Blunder> tape = read_svx_text(ring(11, 5, 5, 0)).survey.blunders;
  ASSERT_FALSE(tape.empty());
  EXPECT_EQ(tape[0].leg, 5);
  EXPECT_EQ(tape[0].reading, "tape");
  EXPECT_NEAR(tape[0].error, 5, 0.01);
  EXPECT_GT(tape[0].sigmas, 15);

  const std::vector<Blunder> compass = read_svx_text(ring(11, 5, 0, 5)).survey.blunders;
  ASSERT_FALSE(compass.empty());
  EXPECT_EQ(compass[0].leg, 5);
  EXPECT_EQ(compass[0].reading, "compass");
  EXPECT_NEAR(compass[0].error, 5 * kPi / 180, 0.01);
}

TEST(Adjust, BlundersAreErrorsThatAReadingCanHave) {
  const std::vector<Blunder> blunders = read_svx_text(ring(11, 5, 200, 0)).survey.blunders;
  ASSERT_FALSE(blunders.empty());
  EXPECT_EQ(blunders[0].reading, "tape");
  EXPECT_NEAR(blunders[0].error, 200, 1);
  for (const Blunder& each : blunders) {
    EXPECT_TRUE(each.reading == "tape" || std::fabs(each.error) <= kPi) << each.reading;
    // Another leg of 10 m was not measured 200 m too long.
    EXPECT_TRUE(each.leg == 5 || each.reading != "tape" || each.error <= 10) << each.error;
  }
}

TEST(Adjust, ComponentsWithoutAFixLieEastOfTheRest) {
  const SvxResult out = read_svx_text("*fix a 1 2 3\na b 10 90 0\nc d 5 0 0\nd e 5 0 0\n");
  expect_near(position_of(out.survey, "c"), {21, 2, 3}, 1e-12);
  expect_near(position_of(out.survey, "e"), {21, 12, 3}, 1e-12);
  ASSERT_EQ(out.warnings.all().size(), 1U);
  EXPECT_EQ(out.warnings.all()[0].where.line, 3);
  const SvxResult single = read_svx_text("a b 10 90 0\n");
  EXPECT_TRUE(single.warnings.all().empty());
  expect_near(position_of(single.survey, "b"), {10, 0, 0}, 1e-12);
}

TEST(Adjust, ComponentsStayApartInFilesOfCoordinates) {
  const Survey survey =
      read_svx_text("1 2 10 0 0\n2 3 5 90 0\na b 10 0 0\nb c 10 90 0\nx y 10 0 0\n").survey;
  EXPECT_EQ(measure(survey).components, 3);
  for (const char* file : {"x.3d", "x.lox", "x.svx"}) {
    SCOPED_TRACE(file);
    Diagnostics warnings;
    Contents contents = format_of(file).read(format_of(file).write(survey), file, {}, warnings);
    Survey* read = std::get_if<Survey>(&contents);
    const Survey again =
        read ? *read : adjust(std::get<Observations>(std::move(contents)), warnings);
    EXPECT_EQ(measure(again).components, 3);
    EXPECT_EQ(measure(again).loops, 0);
    EXPECT_EQ(again.equates.size(), 0U);
  }
}

TEST(Adjust, TraversesBetweenFixedStationsAreCorrected) {
  const Survey survey =
      read_svx_text("*fix 1 0 0 0\n*fix 3 20.4 0 0\n1 2 10 90 0\n2 3 10 90 0\n3 4 1 0 0\n").survey;
  expect_near(position_of(survey, "2"), {10.2, 0, 0}, 1e-9);
  expect_near(position_of(survey, "4"), {20.4, 1, 0}, 1e-9);
  ASSERT_EQ(survey.misclosures.size(), 1U);
  EXPECT_NEAR(survey.misclosures[0].error.x, -0.4, 1e-12);
}

TEST(Adjust, BridgesBetweenLoopsHaveNoMisclosure) {
  const Survey survey = read_svx_text(
                            "*fix 1 0 0 0\n1 2 10 0 0\n2 3 10 120 0\n3 1 10 241 0\n3 4 5 90 3\n"
                            "4 5 10 0 0\n5 6 10 120 0\n6 4 10.2 240 0\n")
                            .survey;
  // The loop of the fixed station has two traverses, the other one starts and ends at a junction.
  ASSERT_EQ(survey.misclosures.size(), 3U);
  for (const Misclosure& each : survey.misclosures) EXPECT_GT(each.e, 0.1);
  const Vec3d bridge = position_of(survey, "4") - position_of(survey, "3");
  expect_near(bridge, {5 * maths::cos(3 * kPi / 180), 0, 5 * maths::sin(3 * kPi / 180)}, 1e-9);
}

TEST(Adjust, EquatesMakeOnePoint) {
  const Survey survey = read_svx_text("*equate a x\n*equate x y\na b 3 0 0\ny c 4 90 0\n").survey;
  expect_near(position_of(survey, "c"), {4, 0, 0}, 1e-12);
  EXPECT_EQ(survey.equates.size(), 2U);
}

TEST(Adjust, TwoPlacesOfAStationAreAnError) {
  try {
    read_svx_text("*fix a 0 0 0\n*equate a b\n*fix b 0 0 1\na c 1 2 3\n");
    ADD_FAILURE();
  } catch (const Error& error) {
    EXPECT_EQ(error.where().line, 3);
    EXPECT_STREQ(error.what(), "the station 'b' is fixed at two places");
  }
}

TEST(Adjust, ThirtyThousandStationsInLoops) {
  // A grid of 100 by 300 stations, of which every second row is tied at both ends.
  std::string text = "*fix g0_0 0 0 0\n";
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 300; ++j) {
      if (j > 0) text += fmt::format("g{}_{} g{}_{} 5.0{} 90 1\n", i, j - 1, i, j, (i + j) % 7);
      if (i > 0 && j % 10 == 0)
        text += fmt::format("g{}_{} g{}_{} 4.9{} 0 -1\n", i - 1, j, i, j, j % 7);
    }
  const Survey survey = read_svx_text(text).survey;
  EXPECT_EQ(survey.stations.size(), 30000U);
  for (const Station& each : survey.stations) ASSERT_TRUE(std::isfinite(each.position.length()));
  const Vec3d corner = position_of(survey, "g99_299");
  EXPECT_NEAR(corner.x, 299 * 5.03, 5);
  EXPECT_NEAR(corner.y, 99 * 4.93, 5);
}

}  // namespace
}  // namespace vug::survey
