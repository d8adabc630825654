// SPDX-License-Identifier: Apache-2.0
// Surveys of our own and of others, compared with the coordinates that Survex's cavern computes.
// .3d files store whole centimetres.
#include "../scan/external_data.h"
#include "programs.h"

#include <vug/base/atomic_file.h>
#include <vug/base/scratch_folder.h>
#include <vug/survey/read_survey.h>
#include <vug/survey/statistics.h>

#include <map>
#include <sstream>

namespace vug::survey {
namespace {

/// The named stations that dump3d prints.
std::map<std::string, Vec3d> dumped_stations(const std::string& dump) {
  std::map<std::string, Vec3d> out;
  std::istringstream lines(dump);
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("NODE ")) continue;
    std::istringstream words(line.substr(5));
    Vec3d p;
    std::string name;
    words >> p.x >> p.y >> p.z >> name;
    if (name != "[]") out[name.substr(1, name.size() - 2)] = p;
  }
  return out;
}

void expect_like_cavern(const std::filesystem::path& file, double tolerance) {
  const ScratchFolder scratch("vug_survey");
  run_in(scratch.path(), "cavern --quiet --quiet -o out '" + file.string() + "'");
  const auto expected = dumped_stations(run_in(scratch.path(), "dump3d out.3d"));
  Diagnostics warnings;
  const Survey survey = read_survey(file, {}, warnings);
  size_t named = 0;
  for (const Station& each : survey.stations) {
    if (each.anonymous()) continue;
    ++named;
    const auto found = expected.find(each.name);
    ASSERT_NE(found, expected.end()) << each.name;
    const Vec3d apart = each.position - found->second;
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(apart[axis], 0, tolerance) << each.name;
  }
  EXPECT_EQ(named, expected.size());
}

TEST(SvxCavern, OwnTextsHaveTheSameCoordinates) {
  VUG_REQUIRE_PROGRAM("cavern");
  int files = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(VUG_TEST_DATA) + "/surveys/survex")) {
    SCOPED_TRACE(entry.path().filename());
    expect_like_cavern(entry.path(), 0.0052);
    ++files;
  }
  EXPECT_GE(files, 10);
}

std::filesystem::path dow_prov() {
  const std::filesystem::path folder = external_data() / "surveys" / "DowProv";
  return external_data().empty() || !std::filesystem::is_directory(folder) ? "" : folder;
}

TEST(SvxCavern, DowProvHasTheReportedSize) {
  if (dow_prov().empty()) GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with surveys/DowProv";
  Diagnostics warnings;
  const Survey survey = read_survey(dow_prov() / "DowProv.svx", {}, warnings);
  const Statistics size = measure(survey);
  EXPECT_EQ(size.stations, 802);
  EXPECT_EQ(size.legs, 805);
  // cavern 1.4.4 prints 4 components and 7 loops. It counts a component for each of several
  // stations that are equated to a fixed one; without the second fix it also prints 4 loops in the
  // cave and 1 in the building.
  EXPECT_EQ(size.components, 2);
  EXPECT_EQ(size.loops, 5);
  EXPECT_NEAR(size.length, 3892.06, 0.005);
  EXPECT_NEAR(size.adjusted_length, 3898.72, 0.2);
  EXPECT_NEAR(size.plan_length, 3498.06, 0.005);
  EXPECT_NEAR(size.vertical_length, 800.30, 0.005);
  EXPECT_NEAR(size.altitude.high, 401, 1e-9);
  EXPECT_NEAR(size.altitude.size(), 75.15, 0.005);
  EXPECT_NEAR(size.north.size(), 1451.74, 0.1);
  EXPECT_NEAR(size.east.size(), 859.62, 0.1);
  EXPECT_EQ(size.degrees,
            (std::map<int, int>{{1, 80}, {2, 661}, {3, 47}, {4, 6}, {5, 6}, {6, 1}, {7, 1}}));
  EXPECT_EQ(size.cross_sections, 58);
  EXPECT_TRUE(warnings.all().empty());
}

TEST(SvxCavern, DowProvHasTheSameCoordinates) {
  if (dow_prov().empty()) GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with surveys/DowProv";
  VUG_REQUIRE_PROGRAM("cavern");
  // cavern 1.4.4 takes the grid convergence of a compound system such as EPSG:7405 as 0; its
  // horizontal part, EPSG:27700, has the convergence that we also compute.
  const ScratchFolder scratch("vug_survey");
  std::filesystem::copy(dow_prov(), scratch.path(), std::filesystem::copy_options::recursive);
  std::string text = read_text(scratch.file("DowProv.svx"));
  const std::string compound = "\n*cs out EPSG:7405";
  const size_t at = text.find(compound);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, compound.size(), "\n*cs out EPSG:27700");
  write_text(scratch.file("plane.svx"), text);
  expect_like_cavern(scratch.file("plane.svx"), 0.01);
}

}  // namespace
}  // namespace vug::survey
