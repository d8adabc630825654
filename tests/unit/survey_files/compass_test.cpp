// SPDX-License-Identifier: Apache-2.0
#include "faults.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey/adjust.h>

#include <cmath>

namespace vug::survey {
namespace {

/// A .dat file whose lines after the titles are `shots`.
std::string dat(const std::string& shots, const std::string& settings = "0.00",
                const std::string& date = "7 10 1979") {
  return "CAVE\r\nSURVEY NAME: A\r\nSURVEY DATE: " + date +
         "\r\nSURVEY TEAM:\r\n\r\nDECLINATION: " + settings +
         "\r\n\r\nFROM TO LEN BEAR INC LEFT UP DOWN RIGHT\r\n\r\n" + shots + "\f\r\n";
}

TEST(Compass, ShotsAreInFeetAndWallsBelongToFrom) {
  const auto survey = std::get<Observations>(
      read_bytes("dat", dat("A1 A2 10 90 0 1 2 3 -9.9 #|LS# x\nA2 A3 10 0 30 1 2 3 4\n"
                            "A3 A4 10 0 0 5 5 5 5\nA4 A4 0 0 0 6 6 6 6\nB1 A4 10 0 0 7 7 7 7\n",
                            "0 FORMAT: DDDDLUDRLAD CORRECTIONS: 0 0 2")));
  ASSERT_EQ(survey.legs.size(), 4U);
  EXPECT_NEAR(survey.legs[0].vector.x, 12 * 0.3048, 1e-12);
  EXPECT_TRUE(survey.legs[0].leg.duplicate && survey.legs[0].leg.splay);
  EXPECT_NEAR(survey.legs[1].vector.z, 6 * 0.3048, 1e-12);
  EXPECT_EQ(survey.legs[0].leg.survey, "A");
  EXPECT_EQ(survey.legs[0].leg.date->first, 29044);  // 1979-07-10
  ASSERT_EQ(survey.tubes.size(), 2U);
  ASSERT_EQ(survey.tubes[0].size(), 3U);
  EXPECT_EQ(survey.stations[static_cast<size_t>(survey.tubes[0][0].station)].name, "A2");
  EXPECT_NEAR(*survey.tubes[0][0].up, 2 * 0.3048, 1e-12);
  EXPECT_EQ(survey.stations[static_cast<size_t>(survey.tubes[0][2].station)].name, "A4");
}

TEST(Compass, NamesBecomeUtf8) {
  const auto survey = std::get<Observations>(read_bytes("dat", dat("\xe9 B 1 0 0 1 1 1 1\n")));
  EXPECT_EQ(survey.stations[0].name, "\u00e9");
}

TEST(Compass, BacksightsAreAveraged) {
  const auto survey = std::get<Observations>(read_bytes(
      "dat",
      dat("A1 A2 10 44 12 1 1 1 1 225 -14\nA2 A3 10 -999 -999 1 1 1 1 268 -32 #|S#\n",
          "1 FORMAT: DDDDLUDRLADadBT CORRECTIONS: 0 0 0 CORRECTIONS2: 1 2 DISCOVERY: 1 1 1")));
  constexpr double kDegree = kPi / 180;
  const Vec3d first = survey.legs[0].vector, second = survey.legs[1].vector;
  // (44 + 1 and 225 + 1 + 1 - 180) / 2; (12 and 14 - 2) / 2.
  EXPECT_NEAR(std::atan2(first.x, first.y), 46 * kDegree, 1e-12);
  EXPECT_NEAR(first.z, 3.048 * std::sin(12 * kDegree), 1e-12);
  EXPECT_NEAR(second.x, 3.048 * std::cos(30 * kDegree), 1e-12);
  EXPECT_NEAR(second.z, 3.048 * std::sin(30 * kDegree), 1e-12);
  EXPECT_TRUE(survey.legs[1].leg.splay);
  // With T, the walls belong to the station TO.
  EXPECT_EQ(survey.stations[static_cast<size_t>(survey.tubes[0][0].station)].name, "A2");
}

// As in Compass, where the last shot of a loop is one whose stations are both known.
TEST(Compass, RepeatedShotsCloseLoopsAtTheirMean) {
  const auto shots = std::get<Observations>(read_bytes(
      "dat", dat("A1 A2 10.0 90 0 1 1 1 1\nA1 A2 10.4 92 2 1 1 1 1\nA2 A1 10.2 271 -1 1 1 1 1\n"
                 "A2 A3 20 0 0 1 1 1 1\n")));
  ASSERT_EQ(shots.legs.size(), 4U);
  const Vec3d mean = (shots.legs[0].vector + shots.legs[1].vector - shots.legs[2].vector) / 3.0;
  Diagnostics warnings;
  const Survey survey = adjust(shots, warnings);
  EXPECT_LT((survey.stations[1].position - survey.stations[0].position - mean).length(), 4e-3);
  EXPECT_EQ(survey.legs.size(), 4U);
  EXPECT_EQ(survey.misclosures.size(), 3U);
  EXPECT_TRUE(warnings.all().empty());
}

TEST(Compass, PlotsHaveLegsWallsAndFlags) {
  const auto survey = std::get<Survey>(
      read_bytes("plt",
                 "Z 0 1 0 1 0 1\r\nSMain\r\nNone D 7 10 1979 CSurvey\r\n"
                 "M 10 20 30 SA1 P 1 -9 2 3 I 0\r\nD 20 20 30 SA2 P 999 999 -9 -9 I 0 FL\r\n"
                 "d 20 30 30 SA3 P 1 1 1 1 I 0 FS\r\nX 0 1 0 1 0 1\r\nN two\r\n"
                 "M 20 20 30 SA2 P 1 1 1 1 I 0\r\nD 5 5 5 SA1 P 2 2 2 2 I 0\r\n\x1a"));
  EXPECT_EQ(survey.title, "Main");
  ASSERT_EQ(survey.legs.size(), 3U);
  EXPECT_TRUE(survey.legs[0].duplicate && survey.legs[1].surface && survey.legs[1].splay);
  EXPECT_NEAR(survey.stations[0].position.x, 20 * 0.3048, 1e-12);
  EXPECT_NEAR(survey.stations[0].position.y, 10 * 0.3048, 1e-12);
  EXPECT_EQ(survey.stations.back().name, "two.A1");
  ASSERT_EQ(survey.tubes.size(), 3U);
  EXPECT_FALSE(survey.tubes[0][0].right);
  EXPECT_NEAR(*survey.tubes[0][0].down, 3 * 0.3048, 1e-12);
}

TEST(Compass, FaultsOfDataNameTheirLine) {
  expect_faults(
      "dat",
      {
          {"", 1, "the file contains no survey"},
          {"CAVE\n", 1, "the file ends inside the header of a survey"},
          {"CAVE\nSURVEY:\n", 2, "expected 'SURVEY NAME:', found 'SURVEY:'"},
          {dat("", "x"), 6, "'x' is not a number"},
          {dat("", "1 FORMAT:"), 6, "the line ends after FORMAT:"},
          {dat("", "1 FORMAT: DDDD"), 6, "the FORMAT 'DDDD' does not have 11 to 15 characters"},
          {dat("", "1 FORMAT: DDDDLUDRLADadB"), 6, "a FORMAT of 14 characters is ambiguous"},
          {dat("", "1 CORRECTIONS: 1 2"), 6, "the line ends where a number is expected"},
          {dat("", "1 COLOUR: 2"), 6, "unknown setting 'COLOUR:'"},
          {dat("", "0", "13 1 1999"), 3, "the month of '1999-13-1' is not from 1 to 12"},
          {dat("", "0", "1 1999"), 3, "'1 1999' is not a date"},
          {dat("A B\n"), 10, "the line ends before LEN"},
          {dat("A B x 0 0 0 0 0 0\n"), 10, "'x' is not a number"},
          {dat("A B nan 0 0 0 0 0 0\n"), 10, "'nan' is not a number"},
          {dat("A B 1e999 0 0 0 0 0 0\n"), 10, "'1e999' is not a number"},
          {dat("A B -1 0 0 0 0 0 0\n"), 10, "the length -1 is negative"},
          {dat("A B 1 361 0 0 0 0 0\n"), 10, "the angle 361 is not between 0 and 360 degrees"},
          {dat("A B 1 0 91 0 0 0 0\n"), 10, "the angle 91 is not between -90 and 90 degrees"},
          {dat("A B 1 -999 0 0 0 0 0\n"), 10, "the bearing is missing"},
          {dat("A B 1 0 -999 0 0 0 0\n"), 10, "the inclination is missing"},
          {dat("A A 1 0 0 0 0 0 0\n"), 10, "the shot leads from 'A' to itself"},
          {dat("A B 1 0 0 0 0 0 0 #|L\n"), 10, "the flags do not end with '#'"},
      });
}

TEST(Compass, FaultsOfPlotsNameTheirLine) {
  expect_faults("plt", {
                           {"", 1, "the file is empty"},
                           {"Q\n", 1, "unknown command 'Q'"},
                           {"M 1 2\n", 1, "the line ends before the elevation"},
                           {"M 1 2 x SA\n", 1, "'x' is not a number"},
                           {"M 1 2 3 A\n", 1, "the name of the station is missing"},
                           {"D 1 2 3 SA\n", 1, "a line to draw precedes the first position"},
                           {"N x D 99 1 1\n", 1, "the month of '1-99-1' is not from 1 to 12"},
                           {"M 1 2 3 SA P 1 2\n", 1, "the line ends before the distance to a wall"},
                       });
}

TEST(Compass, FaultsOfProjectsNameTheirLine) {
  expect_faults(
      "mak", {
                 {"", 1, "the project lists no .dat file"},
                 {"/ x\n\n#a.dat", 3, "an entry is not closed"},
                 {"?x;\n", 1, "unknown entry '?x'"},
                 {"$61;\n", 1, "'61' is not a UTM zone"},
                 {"@1,2,3;\n", 1, "a place has 5 numbers, found 3"},
                 {"%x;\n", 1, "'x' is not a number"},
                 {"\n#../../etc/a.dat;\n", 2,
                  "the file '../../etc/a.dat' is outside of the survey's folder"},
                 {"#/etc/passwd;\n", 1, "the file '/etc/passwd' is outside of the survey's folder"},
                 {"#no_such.dat;\n", 1, "cannot read the file 'no_such.dat': no such file"},
             });
}

TEST(Compass, ProjectsMayReadOutsideIfAllowed) {
  const ScratchFolder folder("vug_mak");
  std::filesystem::create_directory(folder.file("in"));
  write_text(folder.file("a.dat"), dat("A B 1 0 0 0 0 0 0\n"));
  const std::filesystem::path file = folder.file("in") / "x.mak";
  Diagnostics warnings;
  const auto read = [&](const ReadOptions& options) {
    return std::get<Observations>(
        format_of(file).read("#..\\A.DAT,A[F,1,2,3];", file, options, warnings));
  };
  EXPECT_THROW(read({}), Error);
  ReadOptions anywhere;
  anywhere.allow_outside = true;
  const Observations survey = read(anywhere);
  EXPECT_EQ(survey.legs.size(), 1U);
  ASSERT_EQ(survey.fixes.size(), 1U);
  EXPECT_NEAR(survey.fixes[0].position.z, 3 * 0.3048, 1e-12);
  ReadOptions wider;
  wider.root = folder.path();
  EXPECT_EQ(read(wider).legs.size(), 1U);
  ReadOptions small = wider;
  small.max_bytes = 50;
  EXPECT_THROW(read(small), Error);
}

}  // namespace
}  // namespace vug::survey
