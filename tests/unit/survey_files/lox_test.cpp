// SPDX-License-Identifier: Apache-2.0
#include "faults.h"
#include "programs.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>

#include <fmt/format.h>

#include <cmath>
#include <cstring>
#include <set>

namespace vug::survey {
namespace {

Survey read_lox(const std::string& bytes) { return std::get<Survey>(read_bytes("lox", bytes)); }

Station named_station(const std::string& name, const Vec3d& position) {
  Station result;
  result.name = name;
  result.position = position;
  return result;
}

Leg leg_of(int from, int to, const std::string& survey) {
  Leg result;
  result.from = from;
  result.to = to;
  result.survey = survey;
  return result;
}

/// Two nested surveys, a tube over two legs, an anonymous station and a scrap.
Survey nested_survey() {
  Survey survey;
  survey.title = "Nested";
  survey.stations = {named_station("a.b.1", {0.125, 2, 3}), named_station("a.b.2", Vec3d(4)),
                     named_station("a.c.1", Vec3d(5)), named_station("top", Vec3d(6)),
                     named_station("", Vec3d(7))};
  survey.stations[0].comment = "pit";
  survey.stations[0].entrance = survey.stations[0].fixed = true;
  survey.stations[4].wall = true;
  survey.legs = {leg_of(0, 1, "a.b"), leg_of(2, 1, "a.c"), leg_of(2, 3, ""), leg_of(1, 4, "a.b")};
  survey.legs[2].surface = survey.legs[1].duplicate = survey.legs[3].splay = true;
  survey.tubes = {{{0, 1, 2, 3, 4}, {1, std::nullopt, 0.0, 1, 1}, {2, 5, 6, 7, 8}}};
  survey.scraps = {{"a.b",
                    {Vec3d(0.0), Vec3d(1, 0, 0), Vec3d(0, 1, 0), Vec3d(0, 0, 1)},
                    {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}}};
  return survey;
}

TEST(Lox, SurveysSurvive) {
  const Survey survey = nested_survey();
  const std::string bytes = format_of("x.lox").write(survey);
  const Survey again = read_lox(bytes);
  EXPECT_EQ(again.title, "Nested");
  ASSERT_EQ(again.stations.size(), survey.stations.size());
  for (size_t i = 0; i < survey.stations.size(); ++i) {
    EXPECT_EQ(again.stations[i].name, survey.stations[i].name);
    EXPECT_EQ(again.stations[i].position, survey.stations[i].position);
    EXPECT_EQ(again.stations[i].comment, survey.stations[i].comment);
    EXPECT_EQ(again.stations[i].entrance, survey.stations[i].entrance);
    EXPECT_EQ(again.stations[i].fixed, survey.stations[i].fixed);
    EXPECT_EQ(again.stations[i].wall, survey.stations[i].wall);
    EXPECT_EQ(again.stations[i].surface, i == 2 || i == 3);
    EXPECT_EQ(again.stations[i].underground, i != 3);
  }
  ASSERT_EQ(again.legs.size(), survey.legs.size());
  for (size_t i = 0; i < survey.legs.size(); ++i) {
    EXPECT_EQ(again.legs[i].survey, survey.legs[i].survey);
    EXPECT_EQ(again.legs[i].from, survey.legs[i].from);
    EXPECT_EQ(again.legs[i].duplicate, survey.legs[i].duplicate);
    EXPECT_EQ(again.legs[i].splay, survey.legs[i].splay);
  }
  // The second leg is measured backwards, so its cross-sections are a tube of their own.
  ASSERT_EQ(again.tubes.size(), 2U);
  EXPECT_EQ(again.tubes[0][1].station, 1);
  EXPECT_FALSE(again.tubes[0][1].left);
  EXPECT_EQ(again.tubes[0][1].right, 0.0);
  EXPECT_EQ(again.tubes[1][0].station, 2);
  EXPECT_EQ(again.tubes[1][0].down, 8);
  ASSERT_EQ(again.scraps.size(), 1U);
  EXPECT_EQ(again.scraps[0].survey, "a.b");
  EXPECT_EQ(again.scraps[0].points, survey.scraps[0].points);
  EXPECT_EQ(again.scraps[0].triangles, survey.scraps[0].triangles);
  EXPECT_EQ(format_of("x.lox").write(again).size(), bytes.size());
}

TEST(Lox, CoordinatesThatAreNotFiniteAreRefused) {
  Survey survey = nested_survey();
  survey.stations[1].position.z = std::nan("");
  EXPECT_THROW(format_of("x.lox").write(survey), Error);
}

/// A file with the numbers of `words`; texts of four characters are words, too.
std::string words(std::initializer_list<uint32_t> words) {
  std::string bytes;
  for (const uint32_t word : words) bytes.append(reinterpret_cast<const char*>(&word), sizeof word);
  return bytes;
}

TEST(Lox, FaultsNameTheirByte) {
  const std::string survey = words({1, 24, 1, 0, 7, 0, 0, 7, 0, 0});  // 40 bytes
  const std::string station =
      words({2, 52, 1, 4, 3, 7, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0x61});  // 72 bytes
  std::string infinite = station;
  infinite.replace(16 + 28 + 6, 2, "\xf0\x7f");
  std::string far = station;
  far.replace(16 + 28 + 6, 2, "\x50\x7f");  // 1e307
  const std::string deep = [] {
    std::string records, header;
    for (uint32_t i = 0; i < 200; ++i) records += words({i, 0, 0, i + 1, 0, 0});
    return words({1, 4800, 200, 0}) + records;
  }();
  expect_faults(
      "lox", {
                 {"", 0, "the file is empty (byte 0)"},
                 {"abc", 0, "the file ends too early (byte 0)"},
                 {"<xml version=1.0>", 0, "unknown chunk 1819113532 (byte 0)"},
                 {words({1, 20, 1, 0}), 0,
                  "20 bytes of records do not match 1 records of 24 bytes (byte 0)"},
                 {words({1, 24, 1, 0}), 0, "the file ends too early (byte 16)"},
                 {words({1, 24, 1, 9, 7, 0, 0, 7, 0, 0}), 0, "the file ends too early (byte 40)"},
                 {words({1, 24, 1, 0, 7, 0, 4, 7, 0, 0}), 0,
                  "4 bytes at 0 exceed the 0 bytes of the chunk's data (byte 20)"},
                 {words({1, 48, 2, 0, 7, 0, 0, 7, 0, 0, 7, 0, 0, 7, 0, 0}), 0,
                  "two surveys have the number 7 (byte 40)"},
                 {station, 0, "survey 7 does not exist (byte 16)"},
                 {survey + station + station, 0, "two stations have the number 3 (byte 128)"},
                 {survey + infinite, 0, "a number is not finite (byte 84)"},
                 {survey + far, 0, "a coordinate exceeds 1000000 km (byte 84)"},
                 {deep + station, 0, "surveys are nested more than 100 levels deep (byte 4832)"},
                 {survey + words({3, 92, 1, 0}) + std::string(92, '\0'), 0,
                  "station 0 does not exist (byte 56)"},
                 {survey + words({4, 32, 1, 0, 0, 7, 1, 0, 0, 0, 0, 0}), 0,
                  "0 bytes of coordinates do not match 1 points (byte 56)"},
                 {survey + words({4, 32, 1, 0, 0, 7, 0, 0, 0, 1, 0, 0}), 0,
                  "0 bytes of corners do not match 1 triangles (byte 56)"},
                 {survey + words({4, 32, 1, 12, 0, 7, 0, 0, 0, 1, 0, 12, 0, 1, 2}), 0,
                  "a triangle uses point 0 of 0 (byte 88)"},
             });
}

TEST(Lox, DamagedFilesAreRefusedOrRead) {
  const std::string bytes = format_of("x.lox").write(nested_survey());
  // The file consists of chunks, so that it can also be cut between two of them.
  EXPECT_EQ(read_damaged("lox", bytes), 3U);
}

TEST(Lox, SurfacesAreDroppedWithAWarning) {
  Diagnostics warnings;
  const std::string bytes = format_of("x.lox").write(nested_survey());
  format_of("x.lox").read(bytes + words({5, 4, 1, 0, 0}), "x.lox", {}, warnings);
  ASSERT_EQ(warnings.all().size(), 1U);
  EXPECT_EQ(warnings.all()[0].message,
            fmt::format("surfaces of the .lox file were dropped (byte {})", bytes.size()));
}

/// One line for each station and leg, with coordinates in centimetres. Legs may have either
/// direction.
std::multiset<std::string> lines(const Survey& survey) {
  std::multiset<std::string> result;
  const auto text = [](const Vec3d& p) {
    return fmt::format("{:.2f} {:.2f} {:.2f}", p.x, p.y, p.z);
  };
  for (const Station& s : survey.stations)
    result.insert(fmt::format("{} [{}]{}{}{}{}", text(s.position), s.name, s.surface ? " S" : "",
                              s.underground ? " U" : "", s.entrance ? " E" : "",
                              s.fixed ? " F" : ""));
  for (const Leg& leg : survey.legs) {
    std::string a = text(survey.stations[static_cast<size_t>(leg.from)].position);
    std::string b = text(survey.stations[static_cast<size_t>(leg.to)].position);
    if (b < a) std::swap(a, b);
    result.insert(fmt::format("{} - {} [{}]{}{}{}", a, b, leg.survey, leg.surface ? " S" : "",
                              leg.duplicate ? " D" : "", leg.splay ? " P" : ""));
  }
  return result;
}

TEST(Lox, FilesOfTherionEqualIts3dFiles) {
  VUG_REQUIRE_PROGRAM("therion");
  for (const std::filesystem::path& text : survey_texts(".th")) {
    SCOPED_TRACE(text);
    const ScratchFolder folder("vug_lox");
    write_text(folder.file("thconfig"), fmt::format("source {}\nexport model -fmt loch -o a.lox\n"
                                                    "export model -fmt survex -o a.3d\n",
                                                    text.string()));
    run_in(folder.path(), "therion -q");
    const Survey lox = read_lox(read_text(folder.file("a.lox")));
    const Survey reference = std::get<Survey>(read_bytes("3d", read_text(folder.file("a.3d"))));
    EXPECT_EQ(lines(lox), lines(reference));
    EXPECT_EQ(lox.equates.size(), reference.equates.size());
    // The file that we write contains the same.
    EXPECT_EQ(lines(read_lox(format_of("x.lox").write(lox))), lines(lox));
  }
}

}  // namespace
}  // namespace vug::survey
