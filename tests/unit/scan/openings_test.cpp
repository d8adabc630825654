// SPDX-License-Identifier: Apache-2.0
#include "building.h"
#include "clouds.h"
#include "external_data.h"

#include <vug/base/error.h>
#include <vug/base/parallel.h>
#include <vug/scan/openings.h>
#include <vug/scan/scores.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace vug::scan {
namespace {

struct Seen {
  PointCloud cloud;
  RangeImage range;
  SurfaceMap map;
};

Seen see(PointCloud cloud, const SurfaceOptions& options = {}, double pixel = 0.02,
         const PlaneOptions& plane_options = {}) {
  const PlaneFit plane = fit_plane(cloud, plane_options, RandomKey(1));
  RangeImage range = range_image(cloud, plane, {.pixel = pixel});
  SurfaceMap map = surface_map(range, options);
  return {std::move(cloud), std::move(range), std::move(map)};
}

std::vector<Box> boxes_of(const std::vector<Opening>& openings) {
  std::vector<Box> out;
  for (const Opening& opening : openings) out.push_back(opening.box);
  return out;
}

std::vector<Box> boxes_of(const std::vector<Hole>& holes) {
  std::vector<Box> out;
  for (const Hole& h : holes)
    out.emplace_back(Vec2d(h.x, h.y), Vec2d(h.x + h.width, h.y + h.height));
  return out;
}

/// Panes without returns above, set back panes in the middle, a door and a shop below.
SyntheticFacade made_facade() {
  SyntheticFacade made{.bow = 0.2};
  for (int i = 0; i < 4; ++i) {
    made.holes.push_back({1 + 2.8 * i, 5.5, 1.2, 1.6, 0});
    made.holes.push_back({1 + 2.8 * i, 3, 1.2, 1.6, 0.12});
  }
  made.holes.push_back({1.5, 0, 1, 2.1, 0.2});
  made.holes.push_back({5, 0.8, 4.5, 1.4, 0.1});
  return made;
}

TEST(Wall, FollowsABowUnderOpenings) {
  const SyntheticFacade made = made_facade();
  const Seen seen = see(made.cloud());
  EXPECT_NEAR(seen.map.walls[0].rms, made.noise, 0.005);
  const PlaneFrame frame = made.frame();
  for (double x = 0.5; x < made.width; x += 0.5)
    for (double y = 0.5; y < made.height; y += 0.5) {
      const double u = 2 * x / made.width - 1;
      const Vec3d p = seen.range.frame.local(frame.world({x, y, made.bow * (1 - u * u)}));
      EXPECT_NEAR(seen.map.walls[0].at({p.x, p.y}), p.z, 0.02) << x << ' ' << y;
    }
}

TEST(Wall, FlatOnesArePlanes) {
  EXPECT_EQ(flat_wall().at({-3, 700}), 0);
  Seen seen = see(SyntheticFacade{.step = 0.2}.cloud(), {.bent = false});
  EXPECT_EQ(seen.map.set_back, 0.05);
  EXPECT_EQ(seen.map.walls[0].depths.size(), 1U);
  EXPECT_THROW(fit_wall(seen.range, {.step = 0}), Error);
  EXPECT_THROW(fit_wall(seen.range, {.noise = std::nan("")}), Error);
  EXPECT_THROW(surface_map(seen.range, {.hull = -1}), Error);
  seen.range.depth.assign(seen.range.depth.size(), std::numeric_limits<float>::quiet_NaN());
  EXPECT_THROW(surface_map(seen.range), Error);  // No wall.
}

TEST(Openings, AreFoundWithTheirKinds) {
  const SyntheticFacade made = made_facade();
  const Seen seen = see(made.cloud());
  for (const bool triangles : {false, true}) {
    const std::vector<Opening> found = triangles
                                           ? openings_by_triangles(seen.cloud, seen.range, seen.map)
                                           : openings_by_raster(seen.range, seen.map);
    const Scores scores = score(boxes_of(found), boxes_of(made.holes));
    EXPECT_EQ(scores.matched, made.holes.size()) << triangles;
    EXPECT_EQ(scores.found, made.holes.size()) << triangles;
    for (size_t t = 0; t < made.holes.size(); ++t) {
      EXPECT_GT(scores.truth[t].best, 0.85) << triangles << ' ' << t;
      ASSERT_TRUE(scores.truth[t].found);
      const Opening& opening = found[*scores.truth[t].found];
      EXPECT_EQ(opening.kind == OpeningKind::door, made.holes[t].y == 0);
      if (made.holes[t].behind > 0)
        EXPECT_NEAR(opening.set_back, made.holes[t].behind, 0.02);
      else
        EXPECT_GT(opening.empty, 0.8);
    }
  }
}

/// Three storeys of three windows; those at the sides are in gables that stand forward.
SyntheticFacade facade_with_gables(double forward) {
  SyntheticFacade made;
  made.holes = {{0, 0, 3.5, 8, -forward}, {8.5, 0, 3.5, 8, -forward}};
  for (int row = 0; row < 3; ++row)
    for (const double x : {1.2, 5.2, 9.7})
      made.holes.push_back({x, 1 + 2.3 * row, 1.2, 1.5, row == 1 ? 0 : 0.15});
  return made;
}

TEST(Openings, AreHolesOfTheWallAroundThem) {
  for (const double forward : {0.25, 0.5, 1.2, -0.4}) {
    SCOPED_TRACE(forward);
    const SyntheticFacade made = facade_with_gables(forward);
    // Gables make the front ambiguous, so the position of the scanner is given.
    const Vec3d scanner = made.frame().world({6, 2, 10});
    const Seen seen = see(made.cloud(), {}, 0.02, {.scanner = scanner});
    EXPECT_NEAR(seen.range.metres_wide(), made.width, 0.1);
    ASSERT_EQ(seen.map.walls.size(), 2U);  // Both gables have one.
    for (const Wall& wall : seen.map.walls) EXPECT_NEAR(wall.rms, made.noise, 0.005);
    const std::vector<Hole> windows(made.holes.begin() + 2, made.holes.end());
    for (const bool triangles : {false, true}) {
      const std::vector<Opening> found =
          triangles ? openings_by_triangles(seen.cloud, seen.range, seen.map)
                    : openings_by_raster(seen.range, seen.map);
      const Scores scores = score(boxes_of(found), boxes_of(windows));
      EXPECT_EQ(scores.matched, 9U) << triangles;
      EXPECT_EQ(scores.found, 9U) << triangles;
      for (size_t t = 0; t < windows.size(); ++t)
        if (windows[t].behind > 0) {
          ASSERT_TRUE(scores.truth[t].found);
          EXPECT_NEAR(found[*scores.truth[t].found].set_back, windows[t].behind, 0.02);
        }
    }
  }
}

TEST(Openings, APaneIsNotAWall) {
  const Seen seen = see(made_facade().cloud());
  EXPECT_EQ(seen.map.walls.size(), 1U);
}

TEST(Openings, PlainMethodsFindHolesInFlatWalls) {
  SyntheticFacade made = made_facade();
  made.bow = 0;
  made.holes.resize(8);
  const Seen seen = see(made.cloud(), {.bent = false});
  const OpeningOptions plain{.tidy = false};
  for (const std::vector<Opening>& found :
       {openings_by_raster(seen.range, seen.map, plain),
        openings_by_triangles(seen.cloud, seen.range, seen.map, plain)}) {
    const Scores scores = score(boxes_of(found), boxes_of(made.holes));
    EXPECT_EQ(scores.matched, 8U);
    EXPECT_EQ(scores.found, 8U);
  }
}

TEST(Openings, SignsAreNotPartOfTheWindowBelow) {
  const SyntheticFacade made{.holes = {{3, 1, 3, 2, 0.15}, {3, 3, 3, 0.8, 0}}};
  const Seen seen = see(made.cloud());
  const Scores scores =
      score(boxes_of(openings_by_raster(seen.range, seen.map)), boxes_of(made.holes));
  EXPECT_GT(scores.truth[0].best, 0.85);
  EXPECT_GT(scores.truth[1].best, 0.75);
}

TEST(Openings, OutsideIsNotAnOpening) {
  // A gable, and a low building next to it.
  PointCloud cloud;
  const SyntheticFacade made{};
  for (const Vec3d& p : made.cloud().positions) {
    const Vec3d local = made.frame().local(p);
    if (local.y < (local.x < 6 ? 8 - std::fabs(local.x - 3) : 3.0)) cloud.positions.push_back(p);
  }
  const Seen seen = see(cloud);
  EXPECT_TRUE(openings_by_raster(seen.range, seen.map).empty());
  EXPECT_TRUE(openings_by_triangles(seen.cloud, seen.range, seen.map).empty());
}

TEST(Openings, TinyInputs) {
  Seen seen;
  seen.range = {1, 1, 0.01, {}, {0.0F}, {1}};
  seen.map = surface_map(seen.range);
  seen.cloud.positions.emplace_back(0.005, 0.005, 0);
  EXPECT_TRUE(openings_by_raster(seen.range, seen.map).empty());
  EXPECT_TRUE(openings_by_triangles(seen.cloud, seen.range, seen.map).empty());
  EXPECT_THROW(openings_by_raster(seen.range, seen.map, {.closing = -1}), Error);
  EXPECT_THROW(openings_by_raster(seen.range, seen.map, {.max_size = kInfinity}), Error);
}

TEST(Openings, DoNotDependOnThreads) {
  const PointCloud cloud = made_facade().cloud();
  std::vector<std::vector<Box>> all;
  for (const int threads : {1, 2, 5, 8}) {
    with_threads(threads, [&] {
      const Seen seen = see(cloud);
      all.push_back(boxes_of(openings_by_raster(seen.range, seen.map)));
      all.push_back(boxes_of(openings_by_triangles(seen.cloud, seen.range, seen.map)));
    });
  }
  for (size_t i = 2; i < all.size(); ++i) EXPECT_EQ(all[i], all[i - 2]);
}

class RealScan : public testing::Test {
 protected:
  Building building(const std::string& name) {
    return read_building(external_data() / "facades/scans" / name / "facade_1");
  }
  void SetUp() override {
    if (external_data().empty() || !is_directory(external_data() / "facades/scans"))
      GTEST_SKIP() << "VUG_EXTERNAL_DATA names no folder with facades/scans";
  }
};

TEST_F(RealScan, EveryDoorAndGroupOfWindowsIsFound) {
  for (const char* name : {"building_1", "building_2"}) {
    const Building real = building(name);
    const PlaneFit plane = fit_plane(real.cloud, {}, RandomKey(1));
    EXPECT_LE(plane.rms, 0.06) << name;
    const RangeImage range = range_image(real.cloud, plane);
    const SurfaceMap map = surface_map(range);
    EXPECT_LE(map.walls[0].rms, 0.015) << name;
    const std::vector<Box> truth = true_boxes(real, range.frame);
    const Scores raster = score(boxes_of(openings_by_raster(range, map)), truth);
    for (size_t t = 0; t < truth.size(); ++t)
      EXPECT_GT(raster.truth[t].best, 0.75) << name << ' ' << real.names[t];
    EXPECT_EQ(raster.recall, 1) << name;
    EXPECT_GE(raster.precision, 0.6) << name;
    const Scores triangles = score(boxes_of(openings_by_triangles(real.cloud, range, map)), truth);
    EXPECT_EQ(triangles.recall, 1) << name;
    EXPECT_GE(triangles.precision, 0.6) << name;
    // Requires the fitted surface of the wall.
    const SurfaceMap flat = surface_map(range, {.bent = false});
    const OpeningOptions plain{.tidy = false};
    EXPECT_LT(score(boxes_of(openings_by_raster(range, flat, plain)), truth).recall, 0.8);
  }
}

}  // namespace
}  // namespace vug::scan
