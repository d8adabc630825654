// SPDX-License-Identifier: Apache-2.0
#include "faults.h"
#include "placed.h"
#include "programs.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey_files/walls/settings.h>

#include <fmt/format.h>

namespace vug::survey {
namespace {

Observations read_srv(const std::string& bytes) {
  return std::get<Observations>(read_bytes("srv", bytes));
}

TEST(Walls, NumbersHaveManyForms) {
  constexpr double kDegree = kPi / 180;
  EXPECT_EQ(walls::parse_distance("12.5", 0.3048), 12.5 * 0.3048);
  EXPECT_EQ(walls::parse_distance("12.5m", 0.3048), 12.5);
  EXPECT_EQ(walls::parse_distance("2F", 1), 2 * 0.3048);
  EXPECT_NEAR(*walls::parse_distance("4i6", 1), 4.5 * 0.3048, 1e-12);
  EXPECT_NEAR(*walls::parse_distance("i6", 1), 0.5 * 0.3048, 1e-12);
  for (const char* bad : {"", "m", "4i", "4i-6", "nan", "1e999", "x"})
    EXPECT_FALSE(walls::parse_distance(bad, 1)) << bad;
  EXPECT_NEAR(*walls::parse_angle("45:30", {}), 45.5 * kDegree, 1e-12);
  EXPECT_NEAR(*walls::parse_angle("-5:30", {}), -5.5 * kDegree, 1e-12);
  EXPECT_NEAR(*walls::parse_angle("S30W", {}), 210 * kDegree, 1e-12);
  EXPECT_NEAR(*walls::parse_angle("N30W", {}), 330 * kDegree, 1e-12);
  EXPECT_NEAR(*walls::parse_angle("100g", {}), 90 * kDegree, 1e-12);
  EXPECT_NEAR(*walls::parse_angle("1600m", {}), 90 * kDegree, 1e-12);
  EXPECT_NEAR(*walls::parse_angle("100p", {}), 45 * kDegree, 1e-12);
  for (const char* bad : {"", "N", "N91E", "5:60", "5:-1", "x", "d"})
    EXPECT_FALSE(walls::parse_angle(bad, {})) << bad;
}

TEST(Walls, PrefixesAndWalls) {
  const Observations survey = read_srv(
      "#units case=lower lrud=f\n#prefix2 Cave\n#prefix Upper\nA B 1 0 -- <1,2,--,-1>\n"
      "B C 1 0 <1,1,1,1>\nC other:D 1 0\nx:y:z:E other:D 1 0\n- C 1 0 90\n");
  EXPECT_EQ(survey.stations[0].name, "Cave.Upper.a");
  EXPECT_EQ(survey.stations[3].name, "Cave.other.d");
  EXPECT_EQ(survey.stations[4].name, "x.y.z.e");
  EXPECT_TRUE(survey.stations[5].wall && survey.legs[4].leg.splay);
  EXPECT_EQ(survey.legs[0].leg.survey, "Cave.Upper");
  ASSERT_EQ(survey.tubes.size(), 1U);
  ASSERT_EQ(survey.tubes[0].size(), 2U);
  EXPECT_FALSE(survey.tubes[0][0].up || survey.tubes[0][0].down);
  EXPECT_EQ(survey.tubes[0][0].right, 2.0);
}

TEST(Walls, TextsEqualThoseOfSurvex) {
  VUG_REQUIRE_PROGRAM("cavern");
  const ScratchFolder folder("vug_walls");
  for (std::filesystem::path text : survey_texts(".srv")) {
    SCOPED_TRACE(text);
    const Observations own = read_srv(read_text(text));
    text.replace_extension(".svx");
    run_in(folder.path(), fmt::format("cavern -q -q --output=a.3d '{}'", text.string()));
    expect_same(own, std::get<Survey>(read_bytes("3d", read_text(folder.file("a.3d")))));
  }
}

TEST(Walls, FaultsNameTheirLine) {
  expect_faults("srv", {
                           {"#[\n", 1, "the comment is not closed"},
                           {"#query x\n", 1, "the directive '#query' is not supported"},
                           {"#units miles\n", 1, "unknown setting 'miles'"},
                           {"#units x=1\n", 1, "the setting 'x=1' is not supported"},
                           {"#units order=dxv\n", 1, "invalid value of 'order=dxv'"},
                           {"#units restore\n", 1, "RESTORE without SAVE"},
                           {"#fix A 1 2\n", 1, "'#fix' has a station and three coordinates"},
                           {"#fix A 1 2 x\n", 1, "'x' is not a length"},
                           {"#fix A W97:43:52.5 N31:16:45 323f\n", 1,
                            "'W97:43:52.5' is a latitude or longitude, which '#fix' does not "
                            "support here"},
                           {"#date 2001\n", 1, "'#date' has no date"},
                           {"#date 2/x/2001\n", 1, "'2001-2-x' is not a date"},
                           {"\nA\n", 2, "the line names fewer than two stations"},
                           {"A B\n", 1, "the line ends before the distance"},
                           {"A B 1\n", 1, "the line ends before the azimuth"},
                           {"A B x 1 1\n", 1, "'x' is not a length"},
                           {"A B -1 1 1\n", 1, "the distance is negative"},
                           {"A B 1 361 1\n", 1, "'361' is not an azimuth"},
                           {"A B 1 1 91\n", 1, "'91' is not a vertical angle"},
                           {"A B 1 -- 45\n", 1, "the azimuth is missing"},
                           {"A A 1 1 1\n", 1, "the leg leads from 'A' to itself"},
                           {"- - 1 1 1\n", 1, "a leg joins two anonymous stations"},
                           {"a:b:c:d:E B 1 1 1\n", 1, "'a:b:c:d:E' is not the name of a station"},
                           {"A B 1 1 1 <1,2\n", 1, "the distances to the walls are not closed"},
                           {"A B 1 1 1 <1,2>\n", 1, "fewer than four distances to the walls"},
                           {"A B 1 1 1 <1,2,3,x>\n", 1, "'x' is not a distance to a wall"},
                           {"#units rect\nA B 1\n", 2, "the line ends before an offset"},
                       });
}

}  // namespace
}  // namespace vug::survey
