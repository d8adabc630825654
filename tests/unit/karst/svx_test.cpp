// SPDX-License-Identifier: Apache-2.0
// A generated cave as a .svx file.
#include "../survey_files/dumped.h"
#include "../survey_files/programs.h"
#include "caves.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/network/from_survey.h>
#include <vug/survey_files/read_survey.h>

#include <map>

namespace vug::karst {
namespace {

TEST(KarstSvx, CavernReadsGeneratedCaves) {
  VUG_REQUIRE_PROGRAM("cavern");
  network::Network cave = generate(small_geology(), small_options());
  ASSERT_GT(cave.stations.size(), 10U);
  for (size_t i = 0; i < cave.stations.size(); ++i) {
    const double wall = 0.25 * static_cast<double>(1 + i % 7);
    cave.stations[i].section = network::CrossSection{wall, 2 * wall, {}, 0.0};
    cave.stations[i].splays = {cave.stations[i].position + Vec3d(wall, 1, 0)};
  }
  cave.stations[0].flags.entrance = true;
  cave.origin = Vec3d(400000, 100000, 250);
  const survey::Survey survey = to_survey(cave);

  const ScratchFolder scratch("vug_karst_svx");
  survey::write_survey(survey, scratch.file("cave.svx"));
  survey::run_in(scratch.path(), "cavern -q -o out cave.svx");
  const auto found = survey::dumped_stations(survey::run_in(scratch.path(), "dump3d out.3d"));
  EXPECT_EQ(found.size(), cave.stations.size());
  for (const survey::Station& station : survey.stations) {
    if (station.anonymous()) continue;
    ASSERT_TRUE(found.count(station.name)) << station.name;
    const Vec3d apart = found.at(station.name) - station.position;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(apart[axis], 0, 0.01) << station.name;
  }

  // The cross-sections, splays and flags return with the network.
  Diagnostics warnings;
  const network::Network again =
      network::from_survey(survey::read_survey(scratch.file("cave.svx"), {}, warnings),
                           {.place = {.origin = cave.origin}});
  EXPECT_TRUE(warnings.all().empty());
  ASSERT_EQ(again.stations.size(), cave.stations.size());
  EXPECT_EQ(again.legs.size(), cave.legs.size());
  std::map<std::string, const network::Station*> named;
  for (const network::Station& station : again.stations) named[station.name] = &station;
  for (const network::Station& station : cave.stations) {
    ASSERT_TRUE(named.count(station.name)) << station.name;
    const network::Station& same = *named[station.name];
    EXPECT_EQ(same.flags.entrance, station.flags.entrance);
    EXPECT_EQ(same.splays.size(), 1U);
    ASSERT_TRUE(same.section) << station.name;
    EXPECT_EQ(same.section->right, station.section->right);
    EXPECT_FALSE(same.section->up);
    EXPECT_EQ(same.section->down, 0.0);
  }
}

}  // namespace
}  // namespace vug::karst
