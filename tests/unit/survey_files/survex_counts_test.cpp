// SPDX-License-Identifier: Apache-2.0
// The components and loops that Survex's cavern reports, compared with its output.
#include "programs.h"
#include "svx_text.h"

#include <vug/base/atomic_file.h>
#include <vug/base/disjoint_sets.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey/statistics.h>
#include <vug/survey_files/read_survey.h>

#include <fmt/ranges.h>

#include <regex>
#include <set>

namespace vug::survey {
namespace {

/// The number before a word of cavern's output; `otherwise` if cavern omits the sentence.
int number_in(const std::string& printed, const std::string& pattern, int otherwise) {
  std::smatch found;
  return std::regex_search(printed, found, std::regex(pattern)) ? std::stoi(found[1]) : otherwise;
}

/// Our counts for a file are those that cavern prints.
void expect_counts_of_cavern(const std::filesystem::path& file) {
  const ScratchFolder scratch("vug_survey");
  const std::string printed =
      run_in(scratch.path(), "cavern -o out '" + std::filesystem::absolute(file).string() + "'");
  Diagnostics warnings;
  const Statistics size = measure(read_survey(file, {}, warnings));
  EXPECT_EQ(size.stations, number_in(printed, "contains (\\d+) survey station", 0)) << printed;
  EXPECT_EQ(size.legs, number_in(printed, "joined by (\\d+) leg", 0)) << printed;
  ASSERT_TRUE(size.survex_components);
  EXPECT_EQ(*size.survex_components, number_in(printed, "has (\\d+) connected", 1)) << printed;
  EXPECT_EQ(*size.survex_loops, number_in(printed, "There (?:are|is) (\\d+) loop", 0)) << printed;
}

/// Legs, fixes and equates between nine stations, in any order or after the fixes. Lines that
/// cavern treats in a special way do not occur: repeated legs, legs between equated stations,
/// equates of two fixed stations, and stations that are not connected to a fixed one.
std::string random_survey_of_nine(uint64_t seed) {
  constexpr uint32_t kStations = 9;
  RandomStream random(RandomKey(seed).at("survex counts"));
  const uint32_t fixes = 1 + random.below(2);
  DisjointSets<uint32_t> equal(kStations);
  const auto fixed = [&](uint32_t station) {
    return equal.root(station) < fixes;  // Roots are the smallest stations of their sets.
  };
  std::set<std::pair<uint32_t, uint32_t>> pairs, legs;
  std::vector<std::string> lines;
  for (uint32_t i = 0; i < fixes; ++i)
    lines.push_back(fmt::format("*fix s{} {} 0 0{}\n", i, 3 * i, seed % 5 == 0 ? " 1 1 1" : ""));
  for (uint32_t i = 1; i < 2 * kStations; ++i) {
    const uint32_t a = i < kStations ? i : random.below(kStations);
    const uint32_t b = random.below(i < kStations ? i : kStations);
    if (a == b || !pairs.insert(std::minmax(a, b)).second) continue;
    const bool equate = random.below(5) < 2 && !(fixed(a) && fixed(b)) && equal.join(a, b);
    if (equate)
      lines.push_back(fmt::format("*equate s{} s{}\n", a, b));
    else
      legs.insert({a, b});
  }
  for (const auto& [a, b] : legs)
    if (equal.root(a) != equal.root(b))
      lines.push_back(fmt::format("s{} s{} 10 {} 0\n", a, b, random.below(360)));
  for (size_t i = lines.size(); seed % 3 != 0 && i > 1; --i)
    std::swap(lines[i - 1], lines[random.below(static_cast<uint32_t>(i))]);
  return fmt::format("{}", fmt::join(lines, ""));
}

TEST(SurvexCounts, RandomSurveys) {
  VUG_REQUIRE_PROGRAM("cavern");
  int different = 0;
  for (uint64_t seed = 0; seed < 60; ++seed) {
    const std::string text = random_survey_of_nine(seed);
    SCOPED_TRACE(text);
    const ScratchFolder scratch("vug_survey");
    write_text(scratch.file("a.svx"), text);
    expect_counts_of_cavern(scratch.file("a.svx"));
    const Statistics size = measure(read_svx_text(text).survey);
    different += size.survex_loops != size.loops;
  }
  EXPECT_GT(different, 10);  // The surveys exercise the rules.
}

TEST(SurvexCounts, TextsOfTheProject) {
  VUG_REQUIRE_PROGRAM("cavern");
  const std::filesystem::path folder = std::string(VUG_TEST_DATA) + "/surveys/survex";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    SCOPED_TRACE(entry.path().filename());
    expect_counts_of_cavern(entry.path());
  }
  for (const char* extension : {".dat", ".mak"})
    for (const auto& file : survey_texts(extension)) {
      SCOPED_TRACE(file.filename());
      expect_counts_of_cavern(file);
    }
}

TEST(SurvexCounts, AFixedStationWithFiveLegsIsTwoComponents) {
  std::string text = "*fix a 0 0 0\n";
  for (int legs = 1; legs < 9; ++legs) {
    text += fmt::format("a b{0} 10 {1} 0\n", legs, 40 * legs);
    const Statistics size = measure(read_svx_text(text).survey);
    EXPECT_EQ(size.loops, 0);
    EXPECT_EQ(size.survex_components, legs < 5 ? 1 : 2) << legs;
    EXPECT_EQ(size.survex_loops, legs < 5 ? 0 : 1) << legs;
  }
}

TEST(SurvexCounts, DeviationsOfAFixRemoveItsComponents) {
  std::string text = "*fix a 0 0 0 1 1 1\n";
  for (int i = 0; i < 7; ++i) text += fmt::format("a b{0} 10 {1} 0\n", i, 40 * i);
  EXPECT_EQ(measure(read_svx_text(text).survey).survex_components, 1);
}

TEST(SurvexCounts, SurveysWithoutFixesAreFixedAtTheirFirstStation) {
  std::string star = "x y 10 0 0\n", away = "y x 10 0 0\n";
  for (int i = 0; i < 6; ++i) star += fmt::format("x b{0} 10 {1} 0\n", i, 40 * i);
  for (int i = 0; i < 6; ++i) away += fmt::format("x b{0} 10 {1} 0\n", i, 40 * i);
  EXPECT_EQ(measure(read_svx_text(star).survey).survex_components, 2);
  EXPECT_EQ(measure(read_svx_text(away).survey).survex_components, 1);
}

TEST(SurvexCounts, CavernRefusesUnconnectedSurveys) {
  const Statistics size = measure(read_svx_text("*fix a 0 0 0\na b 10 0 0\nc d 10 0 0\n").survey);
  EXPECT_EQ(size.components, 2);
  EXPECT_FALSE(size.survex_loops);
}

}  // namespace
}  // namespace vug::survey
