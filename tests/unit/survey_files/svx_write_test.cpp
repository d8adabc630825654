// SPDX-License-Identifier: Apache-2.0
// Surveys that are written as .svx files and read again, by the reader and by cavern.
#include "../scan/external_data.h"
#include "dumped.h"
#include "programs.h"
#include "svx_text.h"

#include <vug/base/atomic_file.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey/dates.h>
#include <vug/survey/statistics.h>
#include <vug/survey_files/read_survey.h>

#include <fmt/format.h>

#include <map>
#include <set>

namespace vug::survey {
namespace {

std::string write_svx(const Survey& survey) { return format_of("x.svx").write(survey); }

/// The survey after writing and reading; the text must not cause warnings.
Survey read_again(const Survey& survey) {
  SvxResult again = read_svx_text(write_svx(survey));
  for (const Diagnostic& each : again.warnings.all())
    ADD_FAILURE() << each.message << "\n" << write_svx(survey);
  return std::move(again.survey);
}

/// Stations with a name and a leg or an equate, the flags of legs and the cross-sections.
void expect_kept(const Survey& survey, const Survey& again) {
  std::map<std::string, const Station*> known;
  for (const Station& each : again.stations) known[each.name] = &each;
  std::vector<bool> used(survey.stations.size(), false);
  for (const Leg& leg : survey.legs)
    used[static_cast<size_t>(leg.from)] = used[static_cast<size_t>(leg.to)] = true;
  for (size_t i = 0; i < used.size(); ++i) {
    const Station& station = survey.stations[i];
    if (station.anonymous() || !used[i]) continue;
    ASSERT_TRUE(known.count(station.name)) << station.name;
    const Station& found = *known[station.name];
    expect_near(found.position, station.position, 2e-4);
    EXPECT_EQ(found.entrance, station.entrance) << station.name;
    EXPECT_EQ(found.surface, station.surface) << station.name;
    EXPECT_EQ(found.underground, station.underground) << station.name;
    EXPECT_TRUE(found.fixed || !station.fixed) << station.name;
    EXPECT_TRUE(found.exported || !station.exported) << station.name;
  }
  const auto legs = [](const Survey& from) {
    std::multiset<std::string> all;
    for (const Leg& leg : from.legs) {
      std::string ends[2];
      for (const int k : {0, 1}) {
        const Station& end = from.stations[static_cast<size_t>(k == 0 ? leg.from : leg.to)];
        ends[k] = end.anonymous() ? (end.wall ? "wall" : "open") : end.name;
      }
      if (ends[1] < ends[0]) std::swap(ends[0], ends[1]);  // Repeated legs are turned.
      all.insert(fmt::format("{} {} {}{}{} {} {}", ends[0], ends[1], leg.surface ? "surface" : "",
                             leg.duplicate ? "duplicate" : "", leg.splay ? "splay" : "",
                             leg.style == Style::nosurvey, leg.date ? leg.date->first : -1));
    }
    return all;
  };
  EXPECT_EQ(legs(again), legs(survey));
  const auto tubes = [](const Survey& from) {
    std::multiset<std::string> all;
    for (const Tube& tube : from.tubes) {
      std::string text;
      for (const CrossSection& each : tube) {
        text += from.stations[static_cast<size_t>(each.station)].name;
        for (const auto& side : {each.left, each.right, each.up, each.down})
          text += side ? fmt::format(" {:.3f}", *side) : " -";
        text += '\n';
      }
      all.insert(text);
    }
    return all;
  };
  EXPECT_EQ(tubes(again), tubes(survey));
}

TEST(SvxWrite, EverythingIsKept) {
  for (const char* extension : {".svx", ".srv", ".dat"})
    for (const auto& file : survey_texts(extension)) {
      SCOPED_TRACE(file);
      Diagnostics warnings;
      const Survey survey = read_survey(file, {}, warnings);
      const Survey again = read_again(survey);
      expect_kept(survey, again);
      EXPECT_EQ(again.title, survey.title);
      EXPECT_EQ(measure(again).components, measure(survey).components);
      EXPECT_EQ(measure(again).loops, measure(survey).loops);
    }
}

/// `count` stations in nested surveys with names of all kinds, joined by legs with all flags.
Survey random_survey(uint64_t seed, int count) {
  RandomStream random{RandomKey(seed)};
  const auto below = [&](int n) {
    return static_cast<int>(random.below(static_cast<uint32_t>(n)));
  };
  const char* levels[] = {"", "cave.", "cave.upper.", "other.", "cave.it's.", "cave.\u00e9."};
  const auto random_name = [&](int number) {
    const char* letter = below(2) ? "P" : "p/";
    return fmt::format("{}{}{}", levels[below(6)], letter, number);
  };
  Survey survey;
  for (int i = 0; i < count; ++i) {
    Station station;
    if (i == 0 || below(6) > 0) station.name = random_name(i);
    for (const int axis : {2, 1, 0}) station.position[axis] = random.uniform() * 3000;
    station.position += Vec3d(4e5, 1e5, 0);
    station.wall = station.anonymous() && below(2) == 0;
    station.entrance = !station.anonymous() && below(9) == 0;
    station.fixed = !station.anonymous() && below(9) == 0;
    survey.stations.push_back(station);
  }
  for (int i = 1; i < count; ++i) {
    // Anonymous stations end one leg, others some.
    for (int k = survey.stations[static_cast<size_t>(i)].anonymous() ? 1 : 1 + below(2); k > 0;
         --k) {
      Leg leg;
      leg.from = below(i);
      while (survey.stations[static_cast<size_t>(leg.from)].anonymous()) --leg.from;
      leg.to = i;
      leg.survey = below(3) == 0 ? "cave" : "cave.upper";
      leg.style = below(12) == 0 ? Style::nosurvey : Style::normal;
      leg.surface = below(5) == 0;
      leg.duplicate = below(5) == 0;
      leg.splay = survey.stations[static_cast<size_t>(i)].wall || below(9) == 0;
      if (below(3) == 0) leg.date = DateRange{36000 + below(100), 36200};
      if (survey.stations[static_cast<size_t>(i)].anonymous()) leg.style = Style::normal;
      survey.legs.push_back(leg);
    }
  }
  for (Leg& leg : survey.legs) {
    Station& end = survey.stations[static_cast<size_t>(leg.to)];
    if (end.anonymous() && !leg.splay) end.wall = false;
    for (const int each : {leg.from, leg.to}) {
      Station& station = survey.stations[static_cast<size_t>(each)];
      (leg.surface ? station.surface : station.underground) = true;
    }
  }
  for (int i = 0; i < count / 10; ++i) {
    Tube tube;
    for (int k = below(4); k >= 0; --k) {
      int at = below(count);
      while (survey.stations[static_cast<size_t>(at)].anonymous()) --at;
      const double left = 0.001 * below(3000);
      tube.push_back({at, left, below(2) ? std::optional(0.0) : std::nullopt, 3.25, 1e3});
    }
    survey.tubes.push_back(tube);
  }
  return survey;
}

TEST(SvxWrite, RandomSurveysAreKept) {
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    SCOPED_TRACE(seed);
    const Survey survey = random_survey(seed, 40);
    expect_kept(survey, read_again(survey));
    EXPECT_EQ(write_svx(survey), write_svx(random_survey(seed, 40)));
  }
}

/// cavern reads the text; each of its stations is where the survey has it.
void expect_accepted(const Survey& survey) {
  const ScratchFolder scratch("vug_svx_write");
  write_text(scratch.file("a.svx"), write_svx(survey));
  const std::string printed = run_in(scratch.path(), "cavern -o out a.svx");
  EXPECT_NE(printed.find("Survey contains"), std::string::npos) << printed;
  const auto found = dumped_stations(run_in(scratch.path(), "dump3d out.3d"));
  size_t compared = 0;
  for (const Station& each : survey.stations) {
    auto at = found.find(each.name);
    if (at == found.end()) at = found.find(each.name + "_2");  // It had the name of a survey.
    if (each.anonymous() || at == found.end()) continue;
    ++compared;
    expect_near(at->second, each.position, 0.01);
  }
  EXPECT_GE(compared, 1U);
  size_t with_legs = 0;
  std::vector<bool> used(survey.stations.size(), false);
  for (const Leg& leg : survey.legs)
    if (leg.from != leg.to)
      used[static_cast<size_t>(leg.from)] = used[static_cast<size_t>(leg.to)] = true;
  for (size_t i = 0; i < used.size(); ++i)
    with_legs += used[i] && !survey.stations[i].anonymous() ? 1 : 0;
  EXPECT_GE(compared, with_legs);
}

TEST(SvxWrite, CavernReadsTheTexts) {
  VUG_REQUIRE_PROGRAM("cavern");
  for (const char* extension : {".svx", ".srv", ".dat", ".th"})
    for (const auto& file : survey_texts(extension)) {
      SCOPED_TRACE(file);
      Diagnostics warnings;
      expect_accepted(read_survey(file, {}, warnings));
    }
  for (uint64_t seed = 1; seed <= 20; ++seed) {
    SCOPED_TRACE(seed);
    expect_accepted(random_survey(seed, 300));
  }
}

TEST(SvxWrite, LargeSurveysOfOthers) {
  VUG_REQUIRE_PROGRAM("cavern");
  const std::filesystem::path file = external_data() / "surveys" / "DowProv" / "DowProv.svx";
  if (external_data().empty() || !std::filesystem::exists(file))
    GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with surveys/DowProv";
  Diagnostics warnings;
  const Survey survey = read_survey(file, {}, warnings);
  expect_accepted(survey);
  const Survey again = read_again(survey);
  expect_kept(survey, again);
  EXPECT_EQ(again.coordinate_system, "EPSG:7405");
  EXPECT_EQ(measure(again).loops, measure(survey).loops);
  EXPECT_EQ(measure(again).cross_sections, measure(survey).cross_sections);
}

TEST(SvxWrite, NamesThatSvxCannotContainAreReplaced) {
  Survey survey;
  for (const char* name : {"a b.1", "a_b.1", "a..2", "*;,", "a b.1", ""}) {
    survey.stations.emplace_back();
    survey.stations.back().name = name;
    survey.stations.back().position = Vec3d(static_cast<double>(survey.stations.size()));
  }
  // The last station, without a name, ends two legs.
  for (int i = 0; i < 5; ++i) {
    survey.legs.emplace_back();
    survey.legs.back().from = i;
    survey.legs.back().to = 5;
  }
  survey.legs.emplace_back();  // A leg from a station to itself is omitted.
  const Survey again = read_again(survey);
  EXPECT_EQ(again.legs.size(), 5U);
  std::map<std::string, double> found;
  for (const Station& each : again.stations) found[each.name] = each.position.x;
  const std::map<std::string, double> expected = {{"a_b.1", 1}, {"a_b.1_2", 2}, {"a._.2", 3},
                                                  {"___", 4},   {"a_b.1_3", 5}, {"anonymous", 6}};
  ASSERT_EQ(found.size(), expected.size());
  for (const auto& [name, x] : expected) {
    ASSERT_TRUE(found.count(name)) << name;
    EXPECT_NEAR(found[name], x, 1e-4) << name;
  }
}

TEST(SvxWrite, StationsAndSurveysHaveDifferentNames) {
  // cavern refuses a name that is both.
  const Survey survey =
      read_svx_text("*fix a 0 0 0\na a.b 10 0 0\na.b a.b_2 10 0 0\na.b.c a 5 5 5\n").survey;
  std::set<std::string> names;
  for (const Station& each : read_again(survey).stations) names.insert(each.name);
  EXPECT_EQ(names, (std::set<std::string>{"a_2", "a.b_3", "a.b_2", "a.b.c"}));
}

TEST(SvxWrite, ComponentsAndEquatesAreFixedOnce) {
  Survey survey = read_svx_text(
                      "*fix a 0 0 0\n*equate a b\na c 10 0 0\nd e 10 0 0\n*data nosurvey from to\n"
                      "c f\n")
                      .survey;
  survey.stations[1].fixed = true;  // Equated to a fixed one.
  const std::string text = write_svx(survey);
  size_t fixes = 0;
  for (size_t at = 0; (at = text.find("*fix", at)) != std::string::npos; ++at) ++fixes;
  EXPECT_EQ(fixes, 3U) << text;  // a, d, f.
  EXPECT_NE(text.find("*equate a b\n"), std::string::npos) << text;
}

TEST(SvxWrite, DatesBeyondThoseOfCavernAreComments) {
  Survey survey = read_svx_text(
                      "*date 1899.12.31\n1 2 10 0 0\n*date 2079.01.01\n2 3 10 0 0\n"
                      "*date 2078.12.31\n3 4 10 0 0\n*date 1900.01.01\n4 5 10 0 0\n")
                      .survey;
  const std::string text = write_svx(survey);
  EXPECT_NE(text.find("1 2 10 0 0 ; 1899-12-31\n2 3 10 0 0 ; 2079-01-01\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("*date 2078.12.31\n"), std::string::npos) << text;
  EXPECT_NE(text.find("*date 1900.01.01\n"), std::string::npos) << text;
}

TEST(SvxWrite, CoordinateSystemsOfTheEarthAreNamed) {
  Survey survey = read_svx_text("1 2 10 0 0\n").survey;
  for (const auto& [system, line] : std::map<std::string, std::string>{
           {"EPSG:27700", "*cs EPSG:27700\n*cs out EPSG:27700\n"},
           {"+proj=utm +zone=33 +datum=WGS84", "*cs custom \"+proj=utm +zone=33 +datum=WGS84\"\n"},
           {"", ""},
           {"nowhere", ""},
           {"EPSG:1", ""}}) {
    survey.coordinate_system = system;
    const std::string text = write_svx(survey);
    EXPECT_EQ(text.find("*cs") != std::string::npos, !line.empty()) << text;
    EXPECT_NE(text.find(line), std::string::npos) << text;
    EXPECT_EQ(read_again(survey).coordinate_system, line.empty() ? "" : system);
  }
}

TEST(SvxWrite, CoordinatesThatAreNotFiniteAreRefused) {
  Survey survey = read_svx_text("1 2 10 0 0\n").survey;
  for (const double wrong : {std::numeric_limits<double>::quiet_NaN(),
                             std::numeric_limits<double>::infinity(), -1e300, 3e9}) {
    survey.stations[1].position.y = wrong;
    EXPECT_THROW(write_svx(survey), Error) << wrong;
  }
  survey.stations[1].position.y = 0;
  survey.tubes = {{{0, std::numeric_limits<double>::infinity(), {}, {}, {}}}};
  EXPECT_THROW(write_svx(survey), Error);
}

}  // namespace
}  // namespace vug::survey
