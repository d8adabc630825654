// SPDX-License-Identifier: Apache-2.0
#include "faults.h"
#include "programs.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey/statistics.h>

#include <fmt/format.h>

#include <set>

namespace vug::survey {
namespace {

Survey read_3d(const std::string& bytes) { return std::get<Survey>(read_bytes("3d", bytes)); }
std::string write_3d(const Survey& survey) { return format_of("x.3d").write(survey); }

Station station(const std::string& name, const Vec3d& position) {
  Station result;
  result.name = name;
  result.position = position;
  return result;
}

Leg leg(int from, int to, const std::string& survey = "a", Style style = Style::normal) {
  Leg result;
  result.from = from;
  result.to = to;
  result.survey = survey;
  result.style = style;
  return result;
}

Survey small_survey() {
  Survey survey;
  survey.title = "Small";
  survey.stations = {station("a.1", {1, 2, 3}), station("a.2", Vec3d(0.0))};
  survey.legs = {leg(0, 1)};
  return survey;
}

constexpr std::nullopt_t kNone = std::nullopt;

const std::string kHeader = "Survex 3D Image File\nv8\nt\n?\n";

TEST(Survex3d, LabelsAndCountsOfEveryLengthSurvive) {
  Survey survey;
  survey.title = "Lengths";
  survey.coordinate_system = "EPSG:27700";
  for (const int length : {0, 1, 14, 15, 16, 17, 254, 255, 256, 300, 3999, 1, 2, 0}) {
    const int n = static_cast<int>(survey.stations.size());
    const std::string name(static_cast<size_t>(length), 'x');
    survey.stations.push_back(station(length > 3990 ? name : fmt::format("{}.{}", name, n),
                                      Vec3d(0.01, -0.01, 1) * static_cast<double>(n)));
    survey.legs.push_back(leg(n, n, name));
  }
  const Survey again = read_3d(write_3d(survey));
  EXPECT_EQ(again.title, survey.title);
  EXPECT_EQ(again.coordinate_system, survey.coordinate_system);
  ASSERT_EQ(again.stations.size(), survey.stations.size());
  ASSERT_EQ(again.legs.size(), survey.legs.size());
  for (size_t i = 0; i < survey.stations.size(); ++i) {
    EXPECT_EQ(again.stations[i].name, survey.stations[i].name);
    EXPECT_NEAR((again.stations[i].position - survey.stations[i].position).length(), 0, 1e-9);
    EXPECT_EQ(again.legs[i].survey, survey.legs[i].survey);
    EXPECT_EQ(again.legs[i].from, survey.legs[i].from);
  }
}

TEST(Survex3d, StylesDatesAndFlagsSurvive) {
  Survey survey = small_survey();
  survey.stations[0].entrance = survey.stations[0].fixed = survey.stations[1].surface = true;
  survey.stations[1].exported = survey.stations[0].underground = true;
  survey.stations.push_back(station("", Vec3d(9)));
  survey.stations[2].wall = true;
  for (const Style style : {Style::normal, Style::diving, Style::cartesian, Style::cylpolar,
                            Style::nosurvey, Style::normal}) {
    survey.legs.push_back(leg(1, 2, "a.b", style));
    survey.legs.back().splay = style == Style::diving;
    survey.legs.back().surface = style == Style::cartesian;
    survey.legs.back().duplicate = style == Style::cylpolar;
    if (style != Style::nosurvey) survey.legs.back().date = DateRange{36892, 36892 + 6};
    if (style == Style::diving) survey.legs.back().date = DateRange{65535, 65535};
  }
  survey.tubes = {{{0, 1.25, kNone, 0.0, 400}, {1, kNone, kNone, kNone, kNone}}, {{1, 1, 2, 3, 4}}};
  const std::string bytes = write_3d(survey);
  const Survey again = read_3d(bytes);
  ASSERT_EQ(again.legs.size(), survey.legs.size());
  for (size_t i = 0; i < survey.legs.size(); ++i) {
    EXPECT_EQ(again.legs[i].style, survey.legs[i].style) << i;
    EXPECT_EQ(again.legs[i].date, survey.legs[i].date) << i;
    EXPECT_EQ(again.legs[i].splay, survey.legs[i].splay) << i;
    EXPECT_EQ(again.legs[i].surface, survey.legs[i].surface) << i;
    EXPECT_EQ(again.legs[i].duplicate, survey.legs[i].duplicate) << i;
  }
  EXPECT_TRUE(again.stations[2].wall && again.stations[2].anonymous());
  EXPECT_TRUE(again.stations[0].fixed && again.stations[0].entrance);
  EXPECT_TRUE(again.stations[1].exported && again.stations[1].surface);
  ASSERT_EQ(again.tubes.size(), 2U);
  EXPECT_EQ(again.tubes[0][0].left, 1.25);
  EXPECT_FALSE(again.tubes[0][0].right);
  EXPECT_EQ(again.tubes[0][0].up, 0.0);
  EXPECT_EQ(again.tubes[0][0].down, 400);
  EXPECT_FALSE(again.tubes[0][1].left);
  EXPECT_EQ(write_3d(again), bytes);
}

TEST(Survex3d, StationsPrecedeCrossSections) {
  Survey survey;
  survey.stations = {station("alone", Vec3d(0.0)), station("b", Vec3d(1.0))};
  survey.tubes = {{{0, 1, 1, 1, 1}, {1, 1, 1, 1, 1}}};
  const std::string bytes = write_3d(survey);
  // An item consists of its code, the change of the label and its data; 0x80 marks a station.
  const size_t name = bytes.find("alone");
  ASSERT_NE(name, bytes.npos);
  EXPECT_EQ(bytes[name - 2] & 0x80, 0x80) << "aven cannot draw sections of stations that follow";
}

TEST(Survex3d, MisclosuresFollowTheirTraverses) {
  Survey survey = small_survey();
  survey.stations.push_back(station("a.3", Vec3d(5)));
  survey.legs = {leg(0, 1), leg(1, 2), leg(2, 0)};
  survey.misclosures.push_back({.stations = {1, 2, 0}, .legs = 2, .length = 12.5, .e = 1.5});
  const Survey again = read_3d(write_3d(survey));
  ASSERT_EQ(again.misclosures.size(), 1U);
  EXPECT_EQ(again.misclosures[0].stations, survey.misclosures[0].stations);
  EXPECT_EQ(again.misclosures[0].legs, 2);
  EXPECT_EQ(again.misclosures[0].length, 12.5);
  EXPECT_EQ(again.misclosures[0].e, 1.5);
  EXPECT_EQ(again.legs.size(), 3U);
}

TEST(Survex3d, StationsAtOnePointAreOneAndLegsPreferTheirSurvey) {
  Survey survey = small_survey();
  survey.stations.push_back(station("b.1", survey.stations[1].position));
  survey.stations.push_back(station("b.2", Vec3d(7)));
  survey.legs.push_back(leg(2, 3, "b"));
  const Survey again = read_3d(write_3d(survey));
  EXPECT_EQ(again.legs[1].from, 2);
  ASSERT_EQ(again.equates.size(), 1U);
  EXPECT_EQ(again.equates[0].a, 1);
  EXPECT_EQ(again.equates[0].b, 2);
}

TEST(Survex3d, PlacesInOneCentimetreStayApart) {
  Survey survey;
  survey.stations = {station("a.0", Vec3d(3, 0, 0)), station("a.1", Vec3d(0)),
                     station("a.2", Vec3d(0.003, 0, 0)), station("b.1", Vec3d(0.003, 0, 0))};
  survey.legs = {leg(0, 1, "a"), leg(0, 2, "a")};
  survey.equates = {{2, 3, {}}};
  const Survey again = read_3d(write_3d(survey));
  ASSERT_EQ(again.equates.size(), 1U);
  EXPECT_EQ(again.equates[0].a, 2);
  EXPECT_EQ(again.equates[0].b, 3);
  EXPECT_EQ(measure(again).loops, 0);
  for (size_t i = 0; i < survey.stations.size(); ++i)
    EXPECT_LE((again.stations[i].position - survey.stations[i].position).length(), 0.0151);
}

TEST(Survex3d, ALegInOneCentimetreIsNotALoop) {
  Survey survey;
  survey.stations = {station("a.1", Vec3d(0)), station("a.2", Vec3d(0)),
                     station("a.3", Vec3d(5, 0, 0))};
  survey.legs = {leg(0, 1, "a"), leg(1, 2, "a")};
  const Survey again = read_3d(write_3d(survey));
  EXPECT_TRUE(again.equates.empty());
  ASSERT_EQ(again.legs.size(), 2U);
  EXPECT_NE(again.legs[0].from, again.legs[0].to);
  EXPECT_EQ(measure(again).loops, 0);
  EXPECT_EQ(measure(again).components, 1);
}

TEST(Survex3d, WhatTheFormatCannotStoreIsRefused) {
  const auto expect = [](Survey survey, const char* message) {
    try {
      write_3d(survey);
      ADD_FAILURE() << message;
    } catch (const Error& error) {
      EXPECT_STREQ(error.what(), message);
    }
  };
  Survey survey = small_survey();
  survey.stations[0].position.x = 3e7;
  expect(survey, "the value 30000000 of the station 'a.1' is not within 21474 km of zero");
  survey.stations[0].position.x = std::nan("");
  expect(survey, "the value nan of the station 'a.1' is not within 21474 km of zero");
  survey = small_survey();
  survey.tubes = {{{0, -1, 1, 1, 1}}};
  expect(survey, "a cross-section at 'a.1' has a negative distance");
  survey = small_survey();
  survey.legs[0].date = DateRange{-1, 0};
  expect(survey, "a date is not between 1900 and 2079, or a range of dates is reversed");
  survey = small_survey();
  survey.stations[0].name = std::string(4001, 'x');
  expect(survey, "a name is longer than 4000 bytes");
}

TEST(Survex3d, FaultsNameTheirByte) {
  const std::string zero(1, '\0');
  const std::string point(12, '\0');
  const auto body = [&](const std::string& items) { return kHeader + zero + items; };
  expect_faults(
      "3d", {
                {"", 0, "the file does not begin as a Survex .3d file (byte 0)"},
                {"PNG and more that is not a survey\n", 0,
                 "the file does not begin as a Survex .3d file (byte 0)"},
                {"Survex 3D Image File\n", 0, "the file ends inside its header (byte 21)"},
                {"Survex 3D Image File\nv7\nt\n?\n", 0,
                 "the version of the .3d file is v7, but only v8 is supported (byte 21)"},
                {"Survex 3D Image File\nBv0.01\nt\n?\n", 0,
                 "the version of the .3d file is Bv0.01, but only v8 is supported (byte 21)"},
                {"Survex 3D Image File\n\x01\x02\n", 0,
                 "the version of the .3d file is not readable, but only v8 is supported (byte 21)"},
                {"Survex 3D Image File\nv8\nt" + zero + zero + "::\n?\n", 0,
                 "the separator of survey levels is not one character (byte 24)"},
                {kHeader, 0, "the file ends too early (byte 28)"},
                {body(""), 0, "the file ends too early (byte 29)"},
                {body(zero), 0, "the file ends too early (byte 30)"},
                {body(zero + zero + "more"), 0, "4 bytes follow the end of the data (byte 31)"},
                {body("\x05"), 0, "unknown item 0x05 (byte 29)"},
                {body("\x20"), 0, "unknown item 0x20 (byte 29)"},
                {body("\x14"), 0, "unknown item 0x14 (byte 29)"},
                {body("\x34"), 0, "unknown item 0x34 (byte 29)"},
                {body("\x0f" + point.substr(1)), 0, "the file ends too early (byte 38)"},
                {body("\x60" + point), 0, "a leg precedes the first position (byte 29)"},
                {body("\x13\x02" + zero + "\x01" + zero), 0,
                 "a range of dates ends before it begins (byte 29)"},
                {body("\x80\x10" + point), 0,
                 "a label removes 1 of the 0 characters of the previous one (byte 30)"},
                {body("\x80" + zero + zero + "\xff\xff\xff\xff\xff"), 0,
                 "a label is longer than 4000 bytes (byte 30)"},
                {body("\x1f\xff\xff\xff\xff" + point + point), 0,
                 "the error of a traverse is negative (byte 29)"},
            });
}

TEST(Survex3d, DamagedFilesAreRefusedOrRead) {
  Survey survey = small_survey();
  survey.tubes = {{{0, 1.25, kNone, 0.0, 400}, {1, kNone, kNone, kNone, kNone}}};
  survey.legs[0].date = DateRange{5, 9};
  survey.misclosures.push_back({.stations = {0, 1}, .legs = 1});
  EXPECT_EQ(read_damaged("3d", write_3d(survey)), 0U);
}

/// The lines of dump3d without the header, moves (legs name both ends) and the dates of
/// cross-sections, which we do not store.
std::multiset<std::string> items(const std::string& dump) {
  std::multiset<std::string> lines;
  std::istringstream in(dump.substr(dump.find("\n--\n") + 4));
  for (std::string line; std::getline(in, line);) {
    if (line.starts_with("XSECT ")) line.erase(line.find(']') + 1);
    lines.insert(line);
  }
  return lines;
}

TEST(Survex3d, FilesOfCavernSurviveAccordingToDump3d) {
  VUG_REQUIRE_PROGRAM("cavern");
  VUG_REQUIRE_PROGRAM("dump3d");
  const ScratchFolder folder("vug_3d");
  for (const std::filesystem::path& text : survey_texts(".svx")) {
    SCOPED_TRACE(text);
    run_in(folder.path(), fmt::format("cavern -q -q --output=a.3d '{}'", text.string()));
    const Survey survey = read_3d(read_text(folder.file("a.3d")));
    write_text(folder.file("b.3d"), write_3d(survey));
    const std::string expected = run_in(folder.path(), "dump3d --legs --show-dates a.3d");
    const std::string written = run_in(folder.path(), "dump3d --legs --show-dates b.3d");
    EXPECT_EQ(items(written), items(expected));
    EXPECT_GE(survey.legs.size(), 1U);
    // Every leg ends at stations of the file, not at invented ones.
    for (const Station& station : survey.stations)
      EXPECT_NE(expected.find(fmt::format("NODE {:.2f} {:.2f} {:.2f} [{}]", station.position.x,
                                          station.position.y, station.position.z, station.name)),
                std::string::npos)
          << station.name;
  }
}

}  // namespace
}  // namespace vug::survey
