// SPDX-License-Identifier: Apache-2.0
// Measurements, styles, settings and names of .svx files.
#include "svx_text.h"

#include <vug/base/maths.h>
#include <vug/survey/dates.h>

#include <cmath>

namespace vug::survey {
namespace {

TEST(Svx, EveryStyleInOneSurvey) {
  const Survey survey =
      read_svx_text(
          "*begin t\n*export 1\n*fix 1 100 200 50\n*units tape feet\n*calibrate tape 0.5\n"
          "*calibrate compass 2\n*declination 3.5 degrees\n1 2 100.5 92 10\n2 3 80.5 212 -15\n"
          "*units tape metres\n*calibrate tape 0\n*sd compass 2 degrees\n3 1 24.9 330 4.5\n"
          "3 4 5.0 - down\n*sd backcompass 2 degrees\n"
          "*data normal from to tape compass clino backcompass backclino\n4 5 10.0 45 5 226 -5.5\n"
          "*data diving from to tape compass fromdepth todepth\n*calibrate depth 0 -1\n"
          "5 6 12.0 120 3.0 6.5\n*data cartesian from to northing easting altitude\n6 7 3 4 -1\n"
          "*data normal from to tape compass clino\n1 .. 2.5 10 0\n1 .. 3.5 190 80\n"
          "*data passage station left right up down\n1 1.0 2.0 3.0 0.5\n2 0.5 - 1.5 0.25\n"
          "3 1 1 1 1\n*end t\n")
          .survey;
  // Coordinates of cavern 1.4.4.
  expect_near(position_of(survey, "t.2"), {130.0079, 199.3769, 55.0745}, 1e-3);
  expect_near(position_of(survey, "t.3"), {116.1757, 180.4106, 48.4309}, 1e-3);
  expect_near(position_of(survey, "t.4"), {116.1757, 180.4106, 43.4309}, 1e-3);
  // The mean of 46.5 and 49.5 degrees, and of 5 and 5.5.
  const Vec3d leg = position_of(survey, "t.5") - position_of(survey, "t.4");
  EXPECT_NEAR(maths::atan2(leg.x, leg.y) * 180 / kPi, 48, 1e-9);
  EXPECT_NEAR(leg.z, 10 * maths::sin(5.25 * kPi / 180), 1e-9);
  const Vec3d dive = position_of(survey, "t.6") - position_of(survey, "t.5");
  expect_near(dive, {9.7868, -5.9974, -3.5}, 1e-3);
  expect_near(position_of(survey, "t.7") - position_of(survey, "t.6"), {4, 3, -1}, 1e-9);
  EXPECT_NEAR(survey.misclosures.at(0).e, 5.111477, 1e-6);
  EXPECT_NEAR(survey.misclosures.at(0).h, 5.468297, 1e-6);
  EXPECT_NEAR(survey.misclosures.at(0).v, 2.334474, 1e-6);
  EXPECT_NEAR(survey.misclosures.at(0).length, 79.76, 0.005);

  expect_near(survey.stations[7].position, {100.4984, 202.4498, 50}, 1e-3);
  EXPECT_TRUE(survey.stations[7].anonymous() && survey.stations[7].wall);
  EXPECT_TRUE(survey.legs[7].splay);
  ASSERT_EQ(survey.tubes.size(), 1U);
  ASSERT_EQ(survey.tubes[0].size(), 3U);
  EXPECT_EQ(survey.tubes[0][1].left, 0.5);
  EXPECT_FALSE(survey.tubes[0][1].right);
}

TEST(Svx, CovariancesOfALeg) {
  Diagnostics warnings;
  const Observations read = observe_svx("2 3 10 0 30\n4 5 5 - down\n6 7 10 90 -\n", warnings);
  const Covariance& sloped = read.legs[0].covariance;
  EXPECT_NEAR(sloped.xx, 0.006545, 1e-6);
  EXPECT_NEAR(sloped.yy, 0.004612, 1e-6);
  EXPECT_NEAR(sloped.zz, 0.007170, 1e-6);
  EXPECT_NEAR(sloped.yz, -0.002215, 1e-6);
  EXPECT_NEAR(sloped.zx, 0, 1e-15);
  const double quarter = std::pow(0.25 * kPi / 180, 2), third = 0.0025 / 3;
  EXPECT_NEAR(read.legs[1].covariance.xx, third + 25 * quarter, 1e-12);
  EXPECT_NEAR(read.legs[1].covariance.zz, third + 0.0025, 1e-12);
  EXPECT_NEAR(read.legs[2].covariance.zz, third + 10, 1e-12);
}

/// The vector of a text's last leg.
Vec3d last_vector(const std::string& text) {
  Diagnostics warnings;
  return observe_svx(text, warnings).legs.back().vector;
}

TEST(Svx, UnitsAndCalibrations) {
  expect_near(last_vector("*units tape feet\n*calibrate tape 0.5\n1 2 100.5 90 0\n"), {30.48, 0, 0},
              1e-9);
  expect_near(last_vector("*calibrate tape 0.5 0.9\n1 2 100.5 90 0\n"), {90, 0, 0}, 1e-9);
  expect_near(last_vector("*calibrate tape 0.5 metres 0.9\n1 2 100.5 90 0\n"), {89.95, 0, 0}, 1e-9);
  expect_near(last_vector("*units tape feet\n*calibrate tape 0.5 feet\n1 2 100.5 90 0\n"),
              {30.48, 0, 0}, 1e-9);
  expect_near(last_vector("*declination 3.5 degrees\n*calibrate compass 2\n1 2 100 88.5 0\n"),
              {100, 0, 0}, 1e-9);
  expect_near(last_vector("*calibrate declination 3.5\n1 2 100 93.5 0\n"), {100, 0, 0}, 1e-9);
  expect_near(last_vector("*units clino percent\n1 2 2 0 100\n"),
              {0, std::sqrt(2.0), std::sqrt(2.0)}, 1e-9);
  expect_near(last_vector("*units compass quadrants\n1 2 2 S30W 0\n"), {-1, -std::sqrt(3.0), 0},
              1e-9);
  expect_near(last_vector("*units compass minutes\n1 2 2 5400 0\n"), {2, 0, 0}, 1e-9);
  expect_near(last_vector("*units tape 0.1 metres\n1 2 20 90 level\n"), {2, 0, 0}, 1e-9);
}

TEST(Svx, ScopesRestoreAllSettings) {
  Diagnostics warnings;
  const Observations read = observe_svx(
      "*begin a\n*units tape feet\n*data nosurvey from to\n*flags surface duplicate\n*case "
      "preserve\n"
      "*date 2000.01.02\n*set comment #\nA B # text\n*end a\nA b 10 0 0 ; text\n",
      warnings);
  EXPECT_EQ(read.stations[0].name, "a.A");
  EXPECT_EQ(read.legs[0].leg.style, Style::nosurvey);
  EXPECT_TRUE(read.legs[0].leg.surface && read.legs[0].leg.duplicate);
  EXPECT_EQ(read.legs[0].leg.date, (DateRange{day_number(2000, 1, 2), day_number(2000, 1, 2)}));
  EXPECT_EQ(read.legs[0].leg.survey, "a");
  EXPECT_EQ(read.stations[2].name, "a");
  EXPECT_FALSE(read.legs[1].leg.surface || read.legs[1].leg.date);
  EXPECT_DOUBLE_EQ(read.legs[1].leg.length, 10);
  EXPECT_TRUE(warnings.all().empty());
}

TEST(Svx, LinesWithStationsAndLegsAlternate) {
  Diagnostics warnings;
  const Observations read = observe_svx(
      "*data normal station newline tape compass clino\n1\n10 0 0\n; a comment\n2\n5 90 "
      "0\n3\n\n7\n1 0 0\n8\n",
      warnings);
  ASSERT_EQ(read.legs.size(), 3U);
  EXPECT_EQ(read.stations[static_cast<size_t>(read.legs[2].leg.from)].name, "7");
  EXPECT_EQ(read.legs[1].leg.where.line, 6);
}

TEST(Svx, AnonymousStationsAreNeverTheSame) {
  Diagnostics warnings;
  const Observations read =
      observe_svx("1 . 1 0 0\n1 .. 1 0 0\n1 ... 1 0 0\n1 . 1 0 0\n", warnings);
  ASSERT_EQ(read.stations.size(), 5U);
  EXPECT_TRUE(read.legs[0].leg.splay && read.legs[1].leg.splay);
  EXPECT_FALSE(read.legs[2].leg.splay);
  EXPECT_FALSE(read.stations[1].wall);
  EXPECT_TRUE(read.stations[2].wall);
}

TEST(Svx, FlagsOfStations) {
  const Survey read =
      read_svx_text(
          "*entrance 2\n*flags surface\n1 2 3 4 5\n*flags not surface\n2 3 4 5 6\n*fix 3 0 0 0\n")
          .survey;
  const auto named = [&](const std::string& name) {
    for (const Station& each : read.stations)
      if (each.name == name) return each;
    return Station{};
  };
  EXPECT_TRUE(named("1").surface && !named("1").underground);
  EXPECT_TRUE(named("2").surface && named("2").underground && named("2").entrance);
  EXPECT_TRUE(named("3").fixed && !named("3").surface);
}

/// The messages of the warnings, one per line.
std::string warnings_of(const std::string& text) {
  std::string all;
  Diagnostics warnings;
  observe_svx(text, warnings);
  for (const Diagnostic& each : warnings.all()) all += each.message + "\n";
  return all;
}

TEST(Svx, FeetOfASystemBecomeMetres) {
  // EPSG:2277 (feet) and EPSG:32139 (metres) have the same projection and false origin.
  const Survey survey = read_svx_text(
                            "*cs EPSG:2277\n*cs out EPSG:32139\n"
                            "*fix 1 2296583.333333333 9842500 100\n1 2 10 0 0\n")
                            .survey;
  expect_near(position_of(survey, "1"), {700000, 3000000, 100}, 1e-3);
}

TEST(Svx, SuspiciousReadingsAreWarnings) {
  EXPECT_EQ(warnings_of("1 2 10 365 0\n"), "the bearing is not between 0 and a full circle\n");
  EXPECT_EQ(warnings_of("1 2 10 360 -90\n"), "");
  EXPECT_EQ(warnings_of("1 2 10 0 95\n"), "the gradient is steeper than 90 degrees\n");
  EXPECT_EQ(warnings_of("1 2 -3 0 0\n"), "the length is negative\n");
  EXPECT_EQ(warnings_of("*calibrate tape 5\n1 2 3 0 0\n"), "the calibrated length is negative\n");
  EXPECT_EQ(warnings_of("1 2 3 90 up\n"),
            "a vertical leg has no bearing; its compass reading is ignored\n");
  EXPECT_EQ(warnings_of("*data normal from to tape compass backcompass clino\n1 2 3 90 275 0\n"),
            "the readings of the compass in both directions differ by 7.1 standard deviations\n");
  EXPECT_EQ(warnings_of("*begin a\n1 2 3 4 5\n*end\n"), "*end of survey 'a' without its name\n");
  EXPECT_EQ(warnings_of("1 2 3 4 5\n*entrance 7\n"),
            "the station '7' is not part of any leg and is omitted\n");
  EXPECT_EQ(warnings_of("1 2 3 4 5\n*equate 1 1\n"), "the station '1' is equated to itself\n");
}

TEST(Svx, SurveysExportTheirStations) {
  const std::string survey = "*begin a\n*export 1\n1 2 3 4 5\n*end a\n";
  EXPECT_EQ(warnings_of(survey + "*equate a.1 x\n"), "");
  EXPECT_EQ(warnings_of(survey + "*equate a.2 x\n"),
            "the survey 'a' does not export the station '2'\n");
  EXPECT_EQ(warnings_of("*begin a\n1 2 3 4 5\n*end a\n*equate a.2 x\n"), "");
}

TEST(Svx, ExportsCanBeInferred) {
  // As in cavern 1.4.4: a station is exported if it is named once while the setting is on.
  const std::string survey = "*begin a\n*export 2\n1 2 3 4 5\n*end a\n";
  EXPECT_EQ(warnings_of("*infer exports on\n" + survey + "*equate a.1 x\n"), "");
  EXPECT_EQ(warnings_of(survey + "*infer exports on\n*equate a.1 x\n"), "");
  EXPECT_EQ(warnings_of("*begin a\n*export 2\n*infer exports on\n1 2 3 4 5\n*infer exports off\n"
                        "3 1 3 4 5\n*end a\n*equate a.1 a.3 x\n"),
            "the survey 'a' does not export the station '3'\n");
}

TEST(Svx, TheNorthOfCartesianData) {
  const std::string data = "*data cartesian from to easting northing altitude\n";
  const std::string leg = data + "1 2 0 100 7\n";
  const auto bearing = [&](const std::string& head) {
    const Vec3d v = last_vector(head + leg);
    EXPECT_NEAR(v.length(), std::hypot(100, 7), 1e-9);
    return maths::atan2(v.x, v.y) * 180 / kPi;
  };
  const std::string place =
      "*cs OSGB:SD\n*cs out EPSG:27700\n*declination auto 97480 72608 225\n*date 1982.02.07\n";
  EXPECT_EQ(bearing("*declination 10 degrees\n"), 0);
  EXPECT_NEAR(bearing("*declination 10 degrees\n*cartesian magnetic\n"), 10, 1e-9);
  EXPECT_EQ(bearing("*cartesian true\n"), 0);
  EXPECT_NEAR(bearing(place + "*cartesian true\n"), 0.0325, 1e-3);
  EXPECT_NEAR(bearing(place + "*cartesian magnetic\n"), -7.1391 + 0.0325, 1e-3);
  EXPECT_NEAR(bearing(place + "*cartesian grid\n"), 0, 1e-9);
  EXPECT_EQ(bearing("*begin\n*cartesian magnetic\n*declination 9 degrees\n*end\n"), 0);

  // The accuracy turns with the leg.
  Diagnostics warnings;
  const Observations read = observe_svx(
      "*cartesian magnetic\n*declination 90 degrees\n*sd northing 2 metres\n" + leg, warnings);
  EXPECT_NEAR(read.legs[0].vector.x, 100, 1e-9);
  EXPECT_NEAR(read.legs[0].covariance.xx, 4, 1e-9);
  EXPECT_NEAR(read.legs[0].covariance.xy, 0, 1e-9);
}

TEST(Svx, MagneticNorthFollowsTheDates) {
  const std::string head = "*cs OSGB:SD\n*cs out EPSG:27700\n*declination auto 97480 72608 225\n";
  const auto bearing = [&](const std::string& date) {
    const Vec3d v = last_vector(head + "*date " + date + "\n1 2 100 0 0\n");
    return maths::atan2(v.x, v.y) * 180 / kPi;
  };
  // The declination minus the convergence of the grid.
  EXPECT_NEAR(bearing("1982.02.07"), -7.1391 + 0.0325, 1e-3);
  EXPECT_NEAR(bearing("2015.10.03"), -1.8117 + 0.0325, 1e-3);
  EXPECT_NEAR(bearing("2015.10.01-2015.10.05"), bearing("2015.10.03"), 1e-12);
  EXPECT_EQ(warnings_of(head + "1 2 100 0 0\n"),
            "the leg has no date; its magnetic declination is taken as 0\n");
  EXPECT_THROW(bearing("2031.01.01"), Error);
}

}  // namespace
}  // namespace vug::survey
