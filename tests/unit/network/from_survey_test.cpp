// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/network/dat.h>
#include <vug/network/from_survey.h>

#include <cmath>

namespace vug::network {
namespace {

int add_station(survey::Survey& survey, const std::string& name, const Vec3d& position) {
  survey::Station station;
  station.name = name;
  station.position = position;
  survey.stations.push_back(station);
  return static_cast<int>(survey.stations.size()) - 1;
}

survey::Leg& add_leg(survey::Survey& survey, int from, int to) {
  survey.legs.emplace_back();
  survey.legs.back().from = from;
  survey.legs.back().to = to;
  return survey.legs.back();
}

/// An entrance with a leg over the surface, a passage of two legs with a splay and cross-sections.
survey::Survey small_cave() {
  survey::Survey survey;
  survey.coordinate_system = "EPSG:27700";
  const int trig = add_station(survey, "trig", Vec3d(1000, 2050, 420));
  const int a = add_station(survey, "cave.1", Vec3d(1000, 2000, 400));
  const int b = add_station(survey, "cave.2", Vec3d(1004, 2000, 399));
  const int c = add_station(survey, "cave.3", Vec3d(1004, 2010, 395));
  const int wall = add_station(survey, "", Vec3d(1004, 2001.5, 399));
  survey.stations[1].entrance = true;
  add_leg(survey, trig, a).surface = true;
  add_leg(survey, a, b).survey = "cave";
  add_leg(survey, b, c).survey = "cave";
  add_leg(survey, wall, b);
  survey.tubes = {{{a, 1.0, {}, {}, {}}, {b, 1.0, 2.0, 3.0, 0.0}}, {{b, 9.0, {}, {}, {}}}};
  return survey;
}

TEST(FromSurvey, TurnsTheHeightUpAndStatesTheOffset) {
  const Network network = from_survey(small_cave());
  ASSERT_EQ(network.stations.size(), 3u);  // Without the trig point and the wall.
  EXPECT_EQ(network.origin, Vec3d(1002, 2005, 398));
  EXPECT_EQ(network.stations[0].position, Vec3d(-2, 2, 5));
  EXPECT_EQ(network.stations[2].position, Vec3d(2, -3, -5));
  EXPECT_EQ(network.coordinate_system, "EPSG:27700");
  EXPECT_TRUE(network.stations[0].flags.entrance);
  EXPECT_EQ(network.legs.size(), 2u);
  EXPECT_EQ(network.legs[1].survey, "cave");
  ASSERT_EQ(network.stations[1].splays.size(), 1u);
  EXPECT_EQ(network.stations[1].splays[0], Vec3d(2, 1, 3.5));
}

TEST(FromSurvey, SurveysWithTheSameOriginKeepTheirPlaces) {
  const Vec3d origin(900, 2000, 100);
  survey::Survey other = small_cave();
  for (survey::Station& station : other.stations) station.position += Vec3d(35, -20, 4);
  const Network a = from_survey(small_cave(), {.place = {.origin = origin}}),
                b = from_survey(other, {.place = {.origin = origin}});
  for (size_t i = 0; i < a.stations.size(); ++i)
    EXPECT_EQ(b.stations[i].position - a.stations[i].position, Vec3d(35, 4, 20));
}

TEST(FromSurvey, RefusesCoordinatesFarFromTheOrigin) {
  survey::Survey far = small_cave();
  for (survey::Station& station : far.stations) station.position += Vec3d(398378, 5674300, 0);
  EXPECT_NO_THROW(from_survey(far));
  try {
    from_survey(far, {.place = {.recenter = false}});
    FAIL() << "was placed";
  } catch (const Error& error) {
    EXPECT_NE(error.hint().find("'origin: (399380, 5676305, 398)'"), std::string::npos)
        << error.hint();
  }
}

TEST(FromSurvey, ChoosesTheCompleteCrossSection) {
  const Network network = from_survey(small_cave());
  ASSERT_TRUE(network.stations[0].section && network.stations[1].section);
  EXPECT_FALSE(network.stations[0].section->right);
  EXPECT_EQ(network.stations[1].section->right, 2.0);
  EXPECT_EQ(network.stations[1].section->left, 1.0);
  EXPECT_FALSE(network.stations[2].section);
}

TEST(FromSurvey, KeepsSurfaceLegsOnRequest) {
  const Network network = from_survey(small_cave(), {.surface = true});
  EXPECT_EQ(network.stations.size(), 4u);
  ASSERT_EQ(network.legs.size(), 3u);
  EXPECT_TRUE(network.legs[0].surface);
}

TEST(FromSurvey, ANamedEndOfASplayIsOnTheWall) {
  survey::Survey survey = small_cave();
  const int named = add_station(survey, "cave.2a", Vec3d(1003, 2000, 399));
  add_leg(survey, 2, named).splay = true;
  const Network network = from_survey(survey);
  EXPECT_EQ(network.stations.size(), 3u);
  EXPECT_EQ(network.stations[1].splays.size(), 2u);
}

/// small_cave with a second survey that begins at the equated station "upper.1" and returns to
/// cave.1 through "upper.3": one loop.
survey::Survey equated_cave() {
  survey::Survey survey = small_cave();
  const int first = add_station(survey, "upper.1", survey.stations[3].position);
  const int middle = add_station(survey, "upper.2", Vec3d(990, 2010, 401));
  const int last = add_station(survey, "upper.3", survey.stations[1].position);
  add_leg(survey, first, middle);
  add_leg(survey, middle, last);
  survey.equates = {{3, first, {}}, {last, 1, {}}};
  survey.tubes.push_back({{first, 1.0, 1.0, 1.0, 1.0}});
  return survey;
}

TEST(FromSurvey, EquatedStationsAreOne) {
  const Network network = from_survey(equated_cave());
  ASSERT_EQ(network.stations.size(), 4u);
  EXPECT_EQ(network.stations[0].name, "cave.1");
  EXPECT_EQ(network.stations[0].equated, std::vector<std::string>{"upper.3"});
  EXPECT_TRUE(network.stations[0].flags.entrance);
  EXPECT_FALSE(network.stations[0].flags.surface);
  EXPECT_EQ(network.stations[2].equated, std::vector<std::string>{"upper.1"});
  ASSERT_TRUE(network.stations[2].section);
  EXPECT_EQ(network.stations[2].section->up, 1.0);
  ASSERT_EQ(network.legs.size(), 4u);
  EXPECT_EQ(network.legs[2].from, 2);
  EXPECT_EQ(network.legs[3].to, 0);
}

TEST(FromSurvey, ALegBetweenEquatedStationsDisappears) {
  survey::Survey survey = equated_cave();
  add_leg(survey, 3, 5);
  EXPECT_EQ(from_survey(survey).legs.size(), 4u);
}

TEST(FromSurvey, EquatesReturnFromToSurvey) {
  const Network network = from_survey(equated_cave());
  const survey::Survey survey = to_survey(network);
  EXPECT_EQ(survey.equates.size(), 2u);
  const Network again = from_survey(survey);
  EXPECT_EQ(links_dat(again), links_dat(network));
  EXPECT_EQ(again.stations[2].equated, network.stations[2].equated);
}

TEST(FromSurvey, ReturnsWhatToSurveyWrote) {
  Network network = from_survey(small_cave());
  network.stations[2].name.clear();
  const survey::Survey survey = to_survey(network);
  EXPECT_EQ(survey.stations[2].name, "1");
  EXPECT_EQ(survey.stations[0].position, Vec3d(1000, 2000, 400));
  const Network again = from_survey(survey);
  EXPECT_EQ(nodes_dat(again), nodes_dat(network));
  EXPECT_EQ(links_dat(again), links_dat(network));
  EXPECT_EQ(again.stations[1].splays, network.stations[1].splays);
  EXPECT_EQ(again.stations[1].section->down, 0.0);
  EXPECT_EQ(again.stations[0].section->left, 1.0);
  EXPECT_FALSE(again.stations[0].section->up);
  EXPECT_TRUE(again.stations[0].flags.entrance);
}

TEST(FromSurvey, RejectsBrokenSurveys) {
  survey::Survey survey = small_cave();
  survey.legs[1].to = 17;
  EXPECT_THROW(from_survey(survey), Error);
  survey = small_cave();
  survey.tubes[0][0].station = -1;
  EXPECT_THROW(from_survey(survey), Error);
  survey = small_cave();
  survey.stations[2].position.z = std::nan("");
  EXPECT_THROW(from_survey(survey), Error);
  survey = small_cave();
  survey.tubes[0][1].left = -1;
  EXPECT_THROW(from_survey(survey), Error);
  EXPECT_TRUE(from_survey({}).stations.empty());
}

}  // namespace
}  // namespace vug::network
