// SPDX-License-Identifier: Apache-2.0
#include "faults.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey_files/text_encoding.h>

#include <cmath>

namespace vug::survey {
namespace {

/// A survey "s" with one centreline.
std::string text(const std::string& lines) {
  return "survey s\ncentreline\n" + lines + "\nendcentreline\nendsurvey\n";
}
std::string data(const std::string& lines) {
  return text("data normal from to length compass clino\n" + lines);
}

Observations read_th(const std::string& bytes) {
  return std::get<Observations>(read_bytes("th", bytes));
}

TEST(Therion, NamesFollowSurveys) {
  const Observations survey = read_th(
      "survey a -title \"First \"\"a\"\"\"\nsurvey b -namespace off\ncentreline\n"
      "data normal from to length compass clino\n1 2@c.d 10 0 0\nstation-names x y\n"
      "1 - 1 0 up\n1 . 1 - down\nendcentreline\nendsurvey b\nequate 1 9@e\nendsurvey\n");
  EXPECT_EQ(survey.title, "First \"a\"");
  ASSERT_EQ(survey.stations.size(), 6U);
  EXPECT_EQ(survey.stations[0].name, "a.1");
  EXPECT_EQ(survey.stations[1].name, "a.d.c.2");
  EXPECT_EQ(survey.stations[2].name, "a.x1y");
  EXPECT_TRUE(survey.stations[3].anonymous() && survey.stations[3].wall);
  EXPECT_TRUE(survey.stations[4].anonymous() && !survey.stations[4].wall);
  EXPECT_EQ(survey.stations[5].name, "a.e.9");
  ASSERT_EQ(survey.equates.size(), 1U);
  EXPECT_EQ(survey.equates[0].where.line, 11);
  EXPECT_TRUE(survey.legs[1].leg.splay && survey.legs[2].leg.splay);
  EXPECT_EQ(survey.legs[0].leg.survey, "a");
}

TEST(Therion, SettingsOfGroupsEnd) {
  const Observations survey = read_th(
      text("date 2001.02.03\ninfer plumbs on\ndata normal from to length compass clino\ngroup\n"
           "flags duplicate surface\nunits length feet\n1 2 10 0 0\nendgroup\n1 3 10 0 90\n"
           "flags not splay approximate\ndate 2002.02.03 - 2002.02.05\n3 4 1 0 0"));
  EXPECT_TRUE(survey.legs[0].leg.duplicate && survey.legs[0].leg.surface);
  EXPECT_NEAR(survey.legs[0].leg.length, 3.048, 1e-12);
  EXPECT_FALSE(survey.legs[1].leg.duplicate);
  EXPECT_EQ(survey.legs[1].vector, Vec3d(0, 0, 10));
  EXPECT_EQ(survey.legs[1].leg.date->first, 36923);  // 2001-02-03
  EXPECT_EQ(survey.legs[2].leg.date->last - survey.legs[2].leg.date->first, 2);
}

TEST(Therion, WallsBelongToTheEndOfLegs) {
  const Observations survey = read_th(
      text("data normal from to length compass clino left right up down\n1 2 10 0 0 1 2 3 4\n"
           "2 3 10 0 0 - - 3 4\n2 4 10 0 0 [1 5] [2 6] 3 4\n2 . 1 0 0 1 1 1 1\n"
           "data dimensions station left right up down\n1 1 2 3 4\n2 1 2 - 4"));
  ASSERT_EQ(survey.tubes.size(), 3U);
  ASSERT_EQ(survey.tubes[0].size(), 2U);
  EXPECT_EQ(survey.tubes[0][0].station, 1);
  EXPECT_FALSE(survey.tubes[0][1].left);
  ASSERT_EQ(survey.tubes[1].size(), 2U);
  EXPECT_EQ(survey.tubes[1][0].left, 1);
  EXPECT_EQ(survey.tubes[1][1].left, 5);
  EXPECT_EQ(survey.tubes[1][1].up, 3);
  EXPECT_FALSE(survey.tubes[2][1].up);
}

TEST(Therion, DeviationsGiveTheCovariance) {
  const Observations survey =
      read_th("grade own\nlength 10 cm\nposition 3 cm\nendgrade\n" +
              data("grade own\n1 2 10 0 0\nsd compass 1 grads\n2 3 10 90 0\n"
                   "fix 1 1 2 3 0.1 0.2 0.3 0.001 0 0"));
  EXPECT_NEAR(survey.legs[0].covariance.yy, 0.01 + 0.0009 / 3, 1e-12);
  EXPECT_NEAR(survey.legs[1].covariance.yy, std::pow(10 * 0.9 * kPi / 180, 2) + 0.0009 / 3, 1e-9);
  ASSERT_TRUE(survey.fixes[0].covariance);
  EXPECT_NEAR(survey.fixes[0].covariance->zz, 0.09, 1e-12);
  EXPECT_EQ(survey.fixes[0].covariance->xy, 0.001);
}

TEST(Therion, AGradeMayBeEmptyAndReplaceAnother) {
  const std::string legs = data("grade own\n1 2 10 0 0");
  const Observations standard = read_th(data("1 2 10 0 0"));
  EXPECT_EQ(read_th("grade own\nendgrade\n" + legs).legs[0].covariance.yy,
            standard.legs[0].covariance.yy);
  EXPECT_EQ(read_th("grade own\nlength 1 m\nendgrade\ngrade own\nendgrade\n" + legs)
                .legs[0]
                .covariance.yy,
            standard.legs[0].covariance.yy);
}

TEST(Therion, EncodingsBecomeUtf8) {
  EXPECT_EQ(read_th("encoding ISO8859-2\nsurvey s -title \"\xb9\xe1\"\nendsurvey\n").title,
            "\u0161\u00e1");
  EXPECT_EQ(read_th("encoding cp1250\nsurvey s -title \"\x9a\x80\"\nendsurvey\n").title,
            "\u0161\u20ac");
  EXPECT_EQ(read_th("encoding cp1252\nsurvey s -title \"\x80\xe9\"\nendsurvey\n").title,
            "\u20ac\u00e9");
  EXPECT_EQ(read_th("encoding iso8859-1\nsurvey s -title \"\xe9\"\nendsurvey\n").title, "\u00e9");
  EXPECT_EQ(as_utf8("\u20ac"), "\u20ac");
  EXPECT_EQ(as_utf8("\x80\xe9\x81"), "\u20ac\u00e9\xc2\x81");
  // A surrogate (U+D800) is not a character of UTF-8.
  EXPECT_EQ(as_utf8("\xed\xa0\x80"), "\u00ed\u00a0\u20ac");
}

TEST(Therion, DrawingsAreSkipped) {
  const Observations survey = read_th(
      "input plan.th2\nscrap s1 -projection plan\npoint 1 2 station\nendscrap\nmap m\ns1\nendmap\n"
      "comment\nsurvey x\nendcomment\njoin a b\n" +
      data("1 \\\n2 10 0 0 # a comment"));
  EXPECT_EQ(survey.legs.size(), 1U);
}

TEST(Therion, FaultsNameTheirLine) {
  expect_faults(
      "th",
      {
          {"survey\n", 1, "'survey' lacks a name"},
          {"survey a.b\n", 1, "the name 'a.b' of a survey contains '@' or '.'"},
          {"survey a\nsurvey b\nendsurvey\n", 1, "the survey 'a' is not closed"},
          {"survey a\nendsurvey b\n", 2, "'endsurvey b' closes the survey 'a'"},
          {"endsurvey\n", 1, "'endsurvey' without 'survey'"},
          {"survey a -title\n", 1, "the option '-title' lacks a value"},
          {"survey a -declination [1]\n", 1, "a declination of a whole survey is not supported"},
          {"\n\ncentreline\n", 3, "'centreline' is not closed"},
          {"comment\n", 1, "'comment' is not closed"},
          {"grade x\n", 1, "'grade' is not closed"},
          {"grade x\nlength 1\nendgrade", 2,
           "a standard deviation has quantities, a number and a unit"},
          {"surve x\n", 1, "unknown command 'surve'"},
          {"import x.3d\n", 1, "'import' is not supported"},
          {"revise x\n", 1, "'revise' is not supported"},
          {"survey \"a\n", 1, "a text in quotes is not closed"},
          {"survey [a\n", 1, "a bracket is not closed"},
          {"survey \xe9\n", 1, "the line has characters that its encoding does not"},
          {"encoding latin9\n", 1, "unknown encoding 'latin9'"},
          {"input\n", 1, "'input' names no file, or more than one"},
          {"input ../x.th\n", 1, "the file '../x.th' is outside of the survey's folder"},
          {"input no_such\n", 1, "cannot read the file 'no_such': no such file"},
          {"equate a\n", 1, "'equate' names fewer than two stations"},
          {"equate a b@\n", 1, "a part of the name 'b@' is empty"},
          {text("1 2 3 4 5"), 3, "'1' is neither a command nor preceded by 'data'"},
          {text("data\n"), 3, "'data' does not name a style"},
          {text("data polar from to\n"), 3, "unknown style of data 'polar'"},
          {text("data normal from to long\n"), 3, "unknown reading 'long'"},
          {text("data normal from to length length\n"), 3, "the reading 'length' is repeated"},
          {text("data normal from to length compass\n"), 3,
           "the readings of this style lack clino"},
          {text("data normal station length compass clino\n"), 3,
           "the readings of this style lack from and to, or station and newline"},
          {data("1 2 10 0"), 4, "the line has 4 of 5 readings"},
          {data("1 2 10 0 0 0"), 4, "the line has more than 5 readings"},
          {data("1 2 x 0 0"), 4, "'x' is not a number"},
          {data("1 2 inf 0 0"), 4, "'inf' is not a number"},
          {data("1 2 - 0 0"), 4, "the reading must not be omitted"},
          {data("1 2 -5 0 0"), 4, "the length is negative after calibration"},
          {data("1 2 5 361 0"), 4, "the bearing 361 is not between 0 and 360"},
          {data("1 2 5 0 91"), 4, "the gradient 91 is steeper than vertical"},
          {data("1 2 5 - 0"), 4, "the bearing is missing"},
          {data("1 1 5 0 0"), 4, "the leg leads from '1' to itself"},
          {data(". - 5 0 0"), 4, "a leg joins two anonymous stations"},
          {data("group"), 4, "'group' is not closed"},
          {data("endgroup"), 4, "'endgroup' without 'group'"},
          {data("flags dark"), 4, "unknown flag 'dark'"},
          {data("units width metres"), 4, "unknown quantity 'width'"},
          {data("units length degrees"), 4, "'degrees' is not a unit of lengths"},
          {data("units length 0 feet"), 4, "a unit must be positive and at most 1000000"},
          {data("calibrate length 0 0"), 4, "the scale must not be zero"},
          {data("sd length -1 metres"), 4,
           "a standard deviation must be between 0.000001 and 1000000"},
          {data("grade BCRA9"), 4, "unknown grade 'BCRA9'"},
          {data("declination 3"), 4, "'declination' lacks an argument"},
          {data("fix 1 2 3"), 4, "'fix' has a station and 3, 6 or 9 numbers"},
          {data("fix 1 2 3 4 0 1 1"), 4, "a standard deviation is out of range"},
          {data("fix 1 2 3 4 1 1 1 1 0 0"), 4,
           "the covariances are too large for the standard deviations"},
          {data("cs lat-long"), 4, "coordinates in degrees are not supported"},
          {data("cs EPSG:4326"), 4,
           "the coordinates of 'EPSG:4326' are degrees, but those of a survey are metres"},
          {data("cs EPSG:2277"), 4,
           "the unit of 'EPSG:2277' is 0.304801 m, but the coordinates of a survey are metres"},
          {data("cs UTM99"), 4, "unknown coordinate system 'UTM99'"},
          {data("cs UTM33\ncs UTM34"), 5,
           "the coordinate system 'EPSG:32634' differs from 'EPSG:32633'"},
          {data("station 1"), 4, "'station' lacks an argument"},
          {data("station 1 \"\" dark"), 4, "unknown flag of a station 'dark'"},
          {data("infer walls on"), 4, "'infer' needs 'plumbs' or 'equates', and 'on' or 'off'"},
          {text("data normal from to length compass clino left\n1 2 3 4 5 -1"), 4,
           "the distance -1 to a wall is negative"},
          {text("data normal from to length compass clino left\n1 2 [3 4] 4 5 1"), 4,
           "'3 4' is not a pair of distances to the walls"},
          {text("data dimensions station left\n1 [2 3]"), 4, "a pair of distances needs a leg"},
          {text("data diving from to length compass fromdepth todepth\n1 2 3 4 5 -"), 4,
           "the reading must not be omitted"},
      });
}

TEST(Therion, InputsStayInTheFolderAndEnd) {
  const ScratchFolder folder("vug_th");
  write_text(folder.file("a.th"), "survey a\ninput sub/b\nendsurvey\n");
  std::filesystem::create_directory(folder.file("sub"));
  write_text(folder.file("sub") / "b.th", data("1 2 10 0 0"));
  Diagnostics warnings;
  const auto read = [&](const std::filesystem::path& file) {
    return std::get<Observations>(
        format_of(file).read(read_text(file), file, ReadOptions{}, warnings));
  };
  EXPECT_EQ(read(folder.file("a.th")).stations[0].name, "a.s.1");
  write_text(folder.file("sub") / "b.th", "input ../a.th\n");
  try {
    read(folder.file("a.th"));
    ADD_FAILURE() << "a cycle was read";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "the file '../a.th' includes itself");
    EXPECT_EQ(std::filesystem::path(error.where().file).filename(), "b.th");
  }
  // The folder of the first file is the limit, also through symbolic links.
  std::filesystem::create_symlink("/etc", folder.file("sub") / "etc");
  write_text(folder.file("sub") / "b.th", "input etc/passwd\n");
  EXPECT_THROW(read(folder.file("a.th")), Error);
}

}  // namespace
}  // namespace vug::survey
