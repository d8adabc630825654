// SPDX-License-Identifier: Apache-2.0
// Points survive a round trip, within the precision of 16 bits.
#include <vug/base/atomic_file.h>
#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/base/scratch_folder.h>
#include <vug/field/boolean.h>
#include <vug/volume/io.h>
#include <vug/volume/voxelize.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vug::volume {
namespace {

namespace fs = std::filesystem;

constexpr double kRadius = 1.7;

/// Points on a ball around a position where floats still have 23 bits per metre, with all
/// attributes of cells. Numbered by `id`.
Points ball_points(size_t count) {
  Points out;
  std::vector<float> pscale(count), heat(count);
  std::vector<Vec3f> normal(count), color(count);
  std::vector<int32_t> id(count);
  std::vector<uint8_t> upper(count), odd(count);
  for (size_t i = 0; i < count; ++i) {
    RandomStream random(RandomKey(3).at(i));
    Vec3d n(random.normal(), random.normal(), random.normal());
    n.normalize();
    out.position.push_back(Vec3f(n * kRadius + Vec3d(-0.3, 0.1, 0.2)));
    normal[i] = Vec3f(n);
    color[i] = Vec3f(static_cast<float>(random.uniform()), 0.5f, 0.25f);
    pscale[i] = 0.013f;
    heat[i] = static_cast<float>(random.normal() * 1e6);
    id[i] = static_cast<int32_t>(i);
    upper[i] = n.y > 0;
    odd[i] = i % 2;
  }
  out.attributes = {{"N", normal, true},
                    {"Cd", color, true},
                    {"pscale", pscale, true},
                    {"id", id},
                    {"heat", heat, true}};
  out.groups = {{"odd", odd}, {"upper", upper}};
  return out;
}

double voxel_for_ball(size_t count) {
  return voxel_for_points(4 * kPi * kRadius * kRadius / static_cast<double>(count));
}

class PointFiles : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_ / name; }

  const ScratchFolder scratch_{"vug_points"};
  const std::filesystem::path& folder_ = scratch_.path();
};

TEST_F(PointFiles, SurviveARoundTripWithinTheirPrecision) {
  const Points points = ball_points(20000);
  const double voxel = voxel_for_ball(points.size());
  write(path("a.vdb"), {point_grid(points, voxel).named("cells")});
  const Points back = read_points(path("a.vdb"));
  ASSERT_EQ(back.size(), points.size());
  const std::vector<int32_t>& id = back.values<int32_t>("id");
  std::vector<int32_t> sorted = id;
  std::sort(sorted.begin(), sorted.end());
  EXPECT_EQ(sorted, points.values<int32_t>("id"));
  // Half a 16-bit step, and the rounding of floats as large as 4.
  const double bound = voxel * 0.5 / 65535 + 2.5e-7;
  double turn = 0;
  for (size_t i = 0; i < back.size(); ++i) {
    const auto from = static_cast<size_t>(id[i]);
    const auto worst = [&](const Vec3f& a, const Vec3f& b) {
      const Vec3f d = a - b;
      return static_cast<double>(std::max({std::fabs(d.x), std::fabs(d.y), std::fabs(d.z)}));
    };
    EXPECT_LE(worst(back.position[i], points.position[from]), bound);
    EXPECT_LE(worst(back.values<Vec3f>("Cd")[i], points.values<Vec3f>("Cd")[from]), 0.5 / 2048);
    EXPECT_NEAR(back.values<float>("pscale")[i], 0.013f, 0.013f / 2048);
    EXPECT_EQ(back.values<float>("heat")[i], points.values<float>("heat")[from]) << "too large";
    EXPECT_EQ(back.members("odd")[i], points.members("odd")[from]);
    EXPECT_EQ(back.members("upper")[i], points.members("upper")[from]);
    const Vec3f &a = back.values<Vec3f>("N")[i], &b = points.values<Vec3f>("N")[from];
    turn = std::max(turn, static_cast<double>(a.cross(b).length() / a.length()));
  }
  EXPECT_LT(turn, 0.05 * kPi / 180);
  EXPECT_GT(turn, 0.0) << "16 bits were asked for";
}

TEST_F(PointFiles, InfoDescribesTheirAttributes) {
  const Points points = ball_points(5000);
  write(path("a.vdb"), {point_grid(points, 0.1).named("cells")});
  const FileInfo file = info(path("a.vdb"));
  ASSERT_EQ(file.grids.size(), 1u);
  EXPECT_EQ(file.grids[0].name, "cells");
  ASSERT_TRUE(file.grids[0].points);
  const PointsInfo& info = *file.grids[0].points;
  EXPECT_EQ(info.count, 5000u);
  std::string lines;
  for (const auto& each : info.attributes)
    lines += each.name + ' ' + each.type + ' ' + each.codec + '\n';
  EXPECT_EQ(lines,
            "P vec3s fxpt16\nN vec3s trnc\nCd vec3s trnc\npscale float trnc\nid int32 null\n"
            "heat float null\n");
  ASSERT_EQ(info.groups.size(), 2u);
  EXPECT_EQ(info.groups[0].name, "odd");
  EXPECT_EQ(info.groups[0].points, 2500u);
  const std::vector<uint8_t>& upper = points.members("upper");
  EXPECT_EQ(info.groups[1].points, std::accumulate(upper.begin(), upper.end(), uint64_t{0}));
  EXPECT_NEAR(info.bounds.max.x, kRadius - 0.3, 0.01);
  EXPECT_NEAR(info.bounds.min.y, -kRadius + 0.1, 0.01);
}

TEST_F(PointFiles, SameBytesForAnyNumberOfThreads) {
  const Points points = ball_points(20000);
  const WriteOptions options{.half = false, .metadata = {{"vug:seed", int64_t{7}}}};
  std::string first;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      write(path("a.vdb"), {point_grid(points, 0.05).named("cells")}, options);
      if (first.empty()) first = read_text(path("a.vdb"));
      EXPECT_TRUE(read_text(path("a.vdb")) == first) << threads;
    });
  }
  const Metadata metadata = info(path("a.vdb")).grids[0].metadata;
  EXPECT_EQ(std::get<double>(metadata.at("vug:metersPerUnit")), 1.0);
  EXPECT_EQ(std::get<int64_t>(metadata.at("vug:seed")), 7);
  write(path("b.vdb"), read(path("a.vdb")), options);
  EXPECT_TRUE(read_text(path("b.vdb")) == first) << "read and written again";
}

TEST_F(PointFiles, TwelvePointsShareAVoxel) {
  const Points points = ball_points(50000);
  const Grid grid = point_grid(points, voxel_for_ball(points.size()));
  const double each = 50000.0 / static_cast<double>(grid.statistics().active_voxels);
  EXPECT_NEAR(each, 12, 2) << "a voxel whose corner is cut has none at times";
}

TEST_F(PointFiles, PointsOfAVoxelKeepTheirOrder) {
  Points points;
  for (int i = 0; i < 100; ++i) points.position.emplace_back(0.001f * static_cast<float>(i % 10));
  std::vector<int32_t> id(100);
  std::iota(id.begin(), id.end(), 0);
  points.attributes = {{"id", id}};
  EXPECT_EQ(vug::volume::points(point_grid(points, 1)).values<int32_t>("id"), id);
  EXPECT_NE(point_grid(points, 1).content(),
            point_grid(Points{points.position, {}, {}}, 1).content());
}

TEST_F(PointFiles, MayBeEmpty) {
  write(path("a.vdb"), {point_grid({}, 1).named("nothing")});
  EXPECT_EQ(read_points(path("a.vdb")).size(), 0u);
  EXPECT_EQ(info(path("a.vdb")).grids[0].points->count, 0u);
}

template <class Work>
std::string fault(const Work& work) {
  try {
    work();
  } catch (const Error& error) {
    return std::string(error.what()) + (error.hint().empty() ? "" : "; " + error.hint());
  }
  return "";
}

TEST_F(PointFiles, FaultsAreReportedInSentences) {
  const Points good = ball_points(10);
  Points points = good;
  points.position[3].y = std::nanf("");
  points.position[4].x = 1e12f;
  EXPECT_EQ(fault([&] { point_grid(points, 0.1); }),
            "2 points are not finite, or too far away for voxels of 0.1 m");
  EXPECT_EQ(fault([&] { point_grid(good, 0); }), "the voxel size of points must be above 0");
  points = good;
  points.groups[0].name = "upper";
  EXPECT_EQ(fault([&] { point_grid(points, 1); }),
            "'upper' is the name of a group of points twice");
  points = good;
  points.attributes[0].name = "P";
  EXPECT_EQ(fault([&] { point_grid(points, 1); }),
            "'P' is the name of an attribute of points twice");
  points.attributes[0].name = "my heat";
  EXPECT_EQ(
      fault([&] { point_grid(points, 1); }),
      "'my heat' is not a valid name for an attribute of points; names have letters, digits and _");
  EXPECT_EQ(fault([&] { good.values<float>("heet"); }),
            "the points have no attribute 'heet'; did you mean 'heat'?");
  EXPECT_EQ(fault([&] { good.values<float>("N"); }),
            "the attribute 'N' of the points has vectors, not numbers");
  EXPECT_EQ(fault([&] { good.members("od"); }),
            "the points have no group 'od'; did you mean 'odd'?");
  VoxelizeOptions coarse;
  const Grid rock = voxelize(field::empty(), coarse).named("rock");
  EXPECT_EQ(fault([&] { vug::volume::points(rock); }), "the grid 'rock' does not contain points");
  write(path("rock.vdb"), {rock});
  EXPECT_EQ(fault([&] { read_points(path("rock.vdb")); }),
            "'" + path("rock.vdb").string() + "' does not contain points");
  EXPECT_NE(fault([&] {
              write(path("b.vdb"), {rock, point_grid(good, 1).named("cells")});
            }).find("points and other grids are in one file"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::volume
