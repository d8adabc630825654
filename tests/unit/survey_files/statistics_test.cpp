// SPDX-License-Identifier: Apache-2.0
// The numbers are those that cavern prints for the same texts.
#include "svx_text.h"

#include <vug/survey/statistics.h>

namespace vug::survey {
namespace {

TEST(SurveyStatistics, FlagsEquatesAndSplays) {
  const Survey survey = read_svx_text(
                            "*fix a 0 0 0\n*fix b 1 1 1\na b 10 0 0\na c 5 90 0\n*flags splay\n"
                            "c d 3 1 2\n*flags not splay\n*equate c e\ne .. 3 4 5\n*flags surface\n"
                            "e f 2 3 4\n*flags not surface duplicate\ne g 2 3 50\n")
                            .survey;
  const Statistics size = measure(survey);
  EXPECT_EQ(size.stations, 8);
  EXPECT_EQ(size.legs, 7);
  EXPECT_EQ(size.equates, 1);
  EXPECT_EQ(size.splays, 2);
  EXPECT_EQ(size.loops, 0);
  EXPECT_EQ(size.components, 1);
  EXPECT_DOUBLE_EQ(size.length, 15);
  EXPECT_NEAR(size.adjusted_length, 6.73, 0.005);
  EXPECT_DOUBLE_EQ(size.plan_length, 15);
  EXPECT_DOUBLE_EQ(size.surface_length, 2);
  EXPECT_DOUBLE_EQ(size.duplicate_length, 2);
  EXPECT_EQ(size.degrees, (std::map<int, int>{{1, 5}, {2, 1}, {3, 1}, {4, 1}}));
  EXPECT_NEAR(size.altitude.size(), 1.53, 0.005);
  EXPECT_EQ(survey.stations[static_cast<size_t>(size.altitude.high_station)].name, "g");
  EXPECT_NEAR(size.east.high, 5.07, 0.005);
}

TEST(SurveyStatistics, RedundantEquatesDoNotCount) {
  const Statistics size = measure(read_svx_text("1 2 10 90 0\n2 3 10 180 0\n3 1 14 315 0\n"
                                                "*equate 3 4\n*equate 4 3\n*equate 1 x\n")
                                      .survey);
  EXPECT_EQ(size.stations, 5);
  EXPECT_EQ(size.legs, 5);
  EXPECT_EQ(size.loops, 1);
  EXPECT_EQ(size.degrees, (std::map<int, int>{{1, 2}, {2, 1}, {3, 2}}));
}

TEST(SurveyStatistics, ComponentsAreCountedWithoutFixes) {
  const Statistics size = measure(
      read_svx_text("*fix a 0 0 0\na b 1 2 3\n*fix c 5 5 5\nc d 1 2 3\n*fix z 1 2 3\n").survey);
  EXPECT_EQ(size.components, 3);
  EXPECT_EQ(size.loops, 0);
  EXPECT_EQ(size.degrees.at(0), 1);
}

TEST(SurveyStatistics, AnEmptySurveyHasNoExtent) {
  const Statistics size = measure({});
  EXPECT_EQ(size.stations, 0);
  EXPECT_EQ(size.altitude.low_station, -1);
}

}  // namespace
}  // namespace vug::survey
