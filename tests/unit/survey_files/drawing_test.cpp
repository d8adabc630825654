// SPDX-License-Identifier: Apache-2.0
#include "svx_text.h"

#include <vug/survey/drawing.h>
#include <vug/survey/extended_elevation.h>

#include <algorithm>
#include <cmath>

namespace vug::survey {
namespace {

const char* const kCave =
    "*entrance 3\n*fix 1 0 0 100\n1 2 10 90 -30\n2 3 5 180 10\n2 4 8 0 60\n4 5 3 - down\n1 5 9 60 "
    "0\n"
    "*equate 5 6\n6 7 4 10 0\n6 . 2 10 0\na b 7 0 45\n";

TEST(ExtendedElevation, EveryLegHasItsLengthAndAltitudes) {
  const Survey survey = read_svx_text(kCave).survey;
  const std::vector<ElevationLeg> legs = extend_elevation(survey);
  ASSERT_EQ(legs.size(), survey.legs.size() - 1);  // Without the splay.
  std::vector<int> drawn;
  for (const ElevationLeg& each : legs) {
    drawn.push_back(each.leg);
    const Leg& leg = survey.legs[static_cast<size_t>(each.leg)];
    const Vec3d& a = survey.stations[static_cast<size_t>(leg.from)].position;
    const Vec3d& b = survey.stations[static_cast<size_t>(leg.to)].position;
    EXPECT_NEAR(each.ends[1].x - each.ends[0].x, std::hypot(b.x - a.x, b.y - a.y), 1e-9);
    EXPECT_NEAR(std::fabs(each.ends[1].y - each.ends[0].y), std::fabs(b.z - a.z), 1e-9);
  }
  std::sort(drawn.begin(), drawn.end());
  EXPECT_EQ(std::unique(drawn.begin(), drawn.end()), drawn.end());
  // The first leg starts at the entrance; the loop is cut once.
  EXPECT_NEAR(legs[0].ends[0].x, 0, 1e-12);
  EXPECT_EQ(legs[0].leg, 1);
  EXPECT_EQ(std::count_if(legs.begin(), legs.end(), [](const ElevationLeg& e) { return e.cut; }),
            1);
  // The component without the entrance is to the right.
  EXPECT_EQ(legs.back().leg, 7);
  for (size_t i = 0; i + 1 < legs.size(); ++i) EXPECT_LT(legs[i].ends[1].x, legs.back().ends[0].x);
}

TEST(Drawings, EscapeTitlesAndDrawEmptySurveys) {
  Survey survey;
  survey.title = "A <b> & \xC3\xA9";
  for (const std::string& text : {plan_svg(survey), elevation_svg(survey)}) {
    EXPECT_NE(text.find("<title>A &lt;b&gt; &amp; "), std::string::npos);
    EXPECT_EQ(text.find("nan"), std::string::npos);
    EXPECT_EQ(text.find("inf"), std::string::npos);
  }
}

TEST(Drawings, ThePlanHasNorthAtTheTop) {
  const std::string text = plan_svg(read_svx_text("*fix 1 0 0 0\n1 2 10 0 0\n").survey);
  EXPECT_NE(text.find("<line class=\"leg\" x1=\"0.00\" y1=\"-0.00\" x2=\"0.00\" y2=\"-10.00\"/>"),
            std::string::npos)
      << text;
}

TEST(Drawings, ThePlanNamesStations) {
  const std::string text = plan_svg(read_svx_text("*entrance 2\n1 2 10 0 0\n").survey);
  EXPECT_NE(text.find("<title>1</title></circle>"), std::string::npos) << text;
  EXPECT_EQ(text.find(">1</text>"), std::string::npos) << text;
  EXPECT_NE(text.find(">2</text>"), std::string::npos) << text;
}

TEST(Drawings, TheElevationNamesStations) {
  const std::string text =
      elevation_svg(read_svx_text("*entrance gate\n1 2 10 0 0\n*equate 2 gate\n").survey);
  EXPECT_NE(text.find("<title>1</title></circle>"), std::string::npos) << text;
  EXPECT_NE(text.find(">gate</text>"), std::string::npos) << text;
}

TEST(Drawings, OnlyThePlanHasAnArrowToTheNorth) {
  const Survey survey = read_svx_text("1 2 10 0 0\n").survey;
  EXPECT_NE(plan_svg(survey).find(">N</text>"), std::string::npos);
  EXPECT_EQ(elevation_svg(survey).find(">N</text>"), std::string::npos);
}

}  // namespace
}  // namespace vug::survey
