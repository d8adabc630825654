// SPDX-License-Identifier: Apache-2.0
// Water and sediment in passages: levels on random networks, and closed forms in straight tubes.
#include "passage_samples.h"

#include <vug/base/error.h>
#include <vug/karst/generate.h>
#include <vug/karst/presets.h>
#include <vug/passages/water/fall.h>
#include <vug/passages/water/polytopes.h>
#include <vug/passages/water/water_body.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace vug::passages {
namespace {

size_t at(int node) { return static_cast<size_t>(node); }

PassageOptions straight_tubes() {
  PassageOptions options;
  options.smooth = false;
  options.rules = {};
  options.fillet = 0;
  return options;
}

// A tube of radius 2 m whose axis runs through these points.
network::Network tube_along(const std::vector<Vec3d>& points) {
  std::vector<std::pair<int, int>> legs;
  for (int i = 0; i + 1 < static_cast<int>(points.size()); ++i) legs.emplace_back(i, i + 1);
  return with_radius(network_of(points, legs), 2);
}

struct WaterCounts {
  size_t pools = 0;
  size_t riffles = 0;
  size_t backwaters = 0;
};

/// Checks that water is above its bed, runs downhill to an outlet, has one level in each pool, and
/// ends at floors that are higher.
void expect_downhill(const Stream& water, const std::string& label, WaterCounts& counts) {
  SCOPED_TRACE(label);
  std::map<int, double> level_of_pool;
  std::map<int, int> nodes_of_pool;
  for (size_t i = 0; i < water.level.size(); ++i) {
    if (!water.wet(static_cast<int>(i))) {
      EXPECT_EQ(water.discharge[i], 0);
      continue;
    }
    EXPECT_GT(water.level[i], water.bed[i]);
    EXPECT_EQ(level_of_pool.emplace(water.pool[i], water.level[i]).first->second, water.level[i])
        << "two levels in one pool";
    ++nodes_of_pool[water.pool[i]];
    if (!(water.discharge[i] > 0)) ++counts.backwaters;
    const int next = water.towards[i];
    if (next < 0) continue;
    ASSERT_TRUE(water.wet(next)) << "the stream ends before its outlet";
    EXPECT_GE(water.level[i], water.level[at(next)]) << "at " << i;
    EXPECT_EQ(water.level[i] == water.level[at(next)], water.pool[i] == water.pool[at(next)]);
  }
  for (const auto& [pool, count] : nodes_of_pool) ++(count > 1 ? counts.pools : counts.riffles);
  const std::vector<std::vector<int>> adjacent = neighbours(water.plan);
  for (size_t i = 0; i < adjacent.size(); ++i)
    for (const int next : adjacent[i])
      if (water.wet(static_cast<int>(i)) && !water.wet(next)) {
        EXPECT_GE(water.bed[at(next)], water.level[i] - 2e-3) << "a wall of water";
      }
}

TEST(Stream, NeverRisesDownstreamInFiftyCaves) {
  WaterCounts counts;
  for (uint64_t seed = 1; seed <= 50; ++seed)
    expect_downhill(stream(random_cave(seed, 50), {}, {.seed = seed}), std::to_string(seed),
                    counts);
  EXPECT_GT(counts.pools, 200u);
  EXPECT_GT(counts.riffles, 200u);
  EXPECT_GT(counts.backwaters, 100u);
}

TEST(Stream, NeverRisesDownstreamInGeneratedCaves) {
  WaterCounts counts;
  for (karst::Preset small : karst::presets()) {
    small.options.samples.count = 600;
    const network::Network cave = karst::generate(small.geology, small.options);
    expect_downhill(stream(cave, {}, {.spacing = 2}), small.name, counts);
  }
  EXPECT_GT(counts.pools, 50u);
}

TEST(Stream, JoinsItsTributaries) {
  network::Network cave =
      network_of({{0, 9, 0}, {0, 8, 30}, {20, 5, 20}, {40, 2, 20}}, {{0, 2}, {1, 2}, {2, 3}});
  cave.stations[0].flags.sink = cave.stations[1].flags.sink = true;
  cave.stations[3].flags.spring = true;
  const Stream water = stream(cave, {}, {.discharge = 0.02});
  for (size_t i = 0; i < water.plan.nodes.size(); ++i) {
    const int station = water.plan.nodes[i].station;
    if (station < 0) continue;
    EXPECT_NEAR(water.discharge[i], station < 2 ? 0.02 : 0.04, 1e-12);
  }
}

// A dip of 2 m between two ends: the pool fills it up to the lower end, whose water has the depth
// of a uniform flow.
TEST(Stream, APoolHasOneLevelUpToItsLip) {
  const network::Network cave = tube_along({{0, 4, 0}, {20, 0, 0}, {40, 2, 0}, {60, 1, 0}});
  const PassageOptions options = straight_tubes();
  const Stream water = stream(cave, options, {.from = {0}, .to = {3}});
  double lip = -1, low = -1;
  for (size_t i = 0; i < water.plan.nodes.size(); ++i) {
    if (water.plan.nodes[i].station == 2) lip = water.level[i];
    if (water.plan.nodes[i].station == 1) low = water.level[i];
  }
  // The floor is highest next to the station, where the sections of both legs end.
  EXPECT_GE(low, lip);
  EXPECT_NEAR(low, lip, 0.05);
  EXPECT_GT(lip, 0.0);
  EXPECT_LT(lip, 0.4);
  const field::Field body = stream_body(cave, options, {.from = {0}, .to = {3}});
  EXPECT_LT(body.value({20, low - 0.01, 0}), 0);
  EXPECT_NEAR(body.value({20, low, 0.3}), 0, 1e-6);
  EXPECT_GT(body.value({20, low + 0.01, 0}), 0);
  // The whole width of the tube is under water, and the rock around it only next to the wall.
  EXPECT_LT(body.value({20, low - 0.05, 1.9}), 0);
  EXPECT_GT(body.value({20, low - 0.05, 2.6}), 0);
}

TEST(Stream, FallsAtPitches) {
  const network::Network cave = tube_along({{0, 20, 0}, {12, 19, 0}, {12.5, 4, 0}, {30, 3, 0}});
  const field::Field body =
      stream_body(cave, straight_tubes(), {.from = {0}, .to = {3}}, {.thickness = 0.15});
  const field::Field air = passages(cave, straight_tubes());
  // At each height of the shaft there is water, in the air, and at most as wide as the channel.
  for (double y = 5; y < 15; y += 0.5) {
    double least = kInfinity;
    double side = kInfinity;
    for (double x = 10.5; x < 16; x += 0.02) {
      if (air.value({x, y, 0}) < 0) least = std::min(least, body.value({x, y, 0}));
      side = std::min(side, body.value({x, y, 1.7}));
    }
    EXPECT_LT(least, 0) << y;
    EXPECT_GT(side, 0) << y;
  }
  const auto part = [&](StreamPart which) {
    return stream_body(cave, straight_tubes(), {.from = {0}, .to = {3}}, {.part = which});
  };
  EXPECT_GT(part(StreamPart::surface).bounds().max.y, 17);
  EXPECT_GT(part(StreamPart::falls).value({20, 1.5, 0}), 1);
  for (double x = 11; x < 15; x += 0.1)
    EXPECT_GT(part(StreamPart::surface).value({x, 10, 0}), 0.3) << x;
}

// The parabola of a free fall from a lip with the critical velocity.
TEST(Stream, TheSheetOfAFallIsAParabola) {
  Fall fall;
  fall.way = {{{0, 10, 0}, {0, 0, 1}}, {{0, 1, 0}, {0, 0, 1}}, {{9, 1, 0}, {0, 0, 1}}};
  fall.foot = 1;
  fall.discharge = 0.4;
  fall.width = 0.5;
  fall.thickness = 0.2;
  std::vector<Polytope> parts;
  append_fall(fall, parts);
  const field::Field sheet = polytopes("fall", parts);
  const double depth = std::cbrt(0.8 * 0.8 / 9.81), speed = std::sqrt(9.81 * depth);
  for (const double time : {0.2, 0.5, 0.9, 1.3}) {
    const Vec3d p(speed * time, 10 - 0.5 * 9.81 * time * time, 0);
    EXPECT_LT(std::fabs(sheet.value(p)), 0.05) << time;
    EXPECT_GT(sheet.value(p + Vec3d(0.3, 0.3, 0)), 0.1) << time;
    EXPECT_GT(sheet.value(p + Vec3d(0, 0, 0.4)), 0.1) << time;
  }
}

// Water on a slope of 4 % in a wide tube: w = 4.83 Q^(1/2), d = (n Q / (w S^(1/2)))^(3/5).
TEST(Stream, UniformFlowHasManningsDepth) {
  const network::Network cave = tube_along({{0, 8, 0}, {200, 0, 0}});
  for (const double discharge : {0.01, 0.1}) {
    const StreamOptions options{.from = {0}, .to = {1}, .discharge = discharge, .roughness = 0.04};
    const Stream water = stream(cave, straight_tubes(), options);
    const double width = 4.83 * std::sqrt(discharge);
    const double depth = std::pow(0.04 * discharge / (width * std::sqrt(0.04)), 0.6);
    int uniform = 0;
    for (size_t i = 0; i < water.level.size(); ++i) {
      EXPECT_NEAR(water.width[i], width, 1e-12);
      const double above = water.level[i] - water.bed[i];
      EXPECT_GT(above, depth * (1 - 1e-3)) << i;
      if (above < depth * (1 + 1e-3)) ++uniform;
    }
    // Elsewhere there is a riffle, or the pool behind it.
    EXPECT_GT(uniform, 20) << discharge;
  }
}

// A slide of 50 degrees and 25 m: a sheet on the rock, thinner than a fall, down to the pool.
TEST(Stream, SlidesOnSteepRock) {
  const double angle = 50 * kPi / 180, length = 25;
  const double top = length * std::sin(angle), far = length * std::cos(angle);
  const network::Network cave =
      tube_along({{-12, top + 0.4, 0}, {0, top, 0}, {far, 0, 0}, {far + 15, -0.5, 0}});
  const double thickness = 0.1;
  const auto part = [&](StreamPart which) {
    return stream_body(cave, straight_tubes(), {.from = {0}, .to = {3}},
                       {.thickness = thickness, .part = which});
  };
  const field::Field sheet = part(StreamPart::falls), pools = part(StreamPart::surface);
  const field::Field air = passages(cave, straight_tubes());
  const Vec3d along(std::cos(angle), -std::sin(angle), 0), up(std::sin(angle), std::cos(angle), 0);
  for (double s = 4; s < length - 4; s += 0.25) {
    const Vec3d bed = Vec3d(0, top, 0) + along * s - up * 2;
    EXPECT_LT(std::fabs(air.value(bed)), 1e-6) << s;
    double wet = 0, lowest = kInfinity;
    for (double h = 0; h < 2; h += 0.005)
      if (sheet.value(bed + up * h) < 0) {
        wet += 0.005;
        lowest = std::min(lowest, h);
      }
    EXPECT_GT(wet, 0.5 * thickness) << s;
    EXPECT_LT(wet, 3 * thickness) << s;
    EXPECT_LT(lowest, 0.03) << s << ": the sheet leaves the rock";
    EXPECT_GT(pools.value(bed + up * 0.5 * thickness), 0) << s;
  }
}

TEST(Sediment, IsLevelAndEndsWhereItWouldSlide) {
  const network::Network cave = tube_along({{0, 0, 0}, {30, 0, 0}, {34, 8, 0}, {60, 8, 0}});
  const field::Field body = sediment_body(cave, straight_tubes(), {.depth = 0.5, .fill = 0.1}, 0.3);
  const double top = -2 + 0.5 + 0.1 * 4;
  for (const double z : {-1.2, 0.0, 1.2}) {
    EXPECT_LT(body.value({15, top - 0.01, z}), 0) << z;
    EXPECT_GT(body.value({15, top + 0.01, z}), 0) << z;
  }
  for (double t = 0.2; t < 0.8; t += 0.1)
    EXPECT_GT(body.value({30 + 4 * t, 8 * t - 1.5, 0}), 0) << t;
}

TEST(Ponds, FillBasinsToTheirLips) {
  const network::Network cave =
      tube_along({{0, 3, 0}, {20, 0, 0}, {40, 2, 0}, {60, -5, 0}, {80, -4, 0}, {90, -9, 0}});
  const FloorPlan plan = floor_plan(cave, straight_tubes(), 1);
  const std::vector<double> bed = sediment_heights(plan, {});
  const std::vector<int> outlet = nodes_at(plan, cave, {5});
  const auto level_at = [&](const std::vector<double>& levels, int station) {
    for (size_t i = 0; i < plan.nodes.size(); ++i)
      if (plan.nodes[i].station == station) return levels[i];
    return -1.0;
  };
  const std::vector<double> full = pond_levels(plan, bed, outlet, 100);
  EXPECT_EQ(level_at(full, 1), bed[at(nodes_at(plan, cave, {2})[0])]);
  EXPECT_EQ(level_at(full, 3), bed[at(nodes_at(plan, cave, {4})[0])]);
  EXPECT_EQ(level_at(full, 0), -kInfinity);
  EXPECT_EQ(level_at(full, 5), -kInfinity);
  const std::vector<double> shallow = pond_levels(plan, bed, outlet, 0.5);
  EXPECT_EQ(level_at(shallow, 1), bed[at(nodes_at(plan, cave, {1})[0])] + 0.5);
}

TEST(Water, RefusesBadOptions) {
  const network::Network cave = tube_along({{0, 0, 0}, {9, -1, 0}});
  const double nan = std::nan("");
  EXPECT_THROW(stream(cave, {}, {.discharge = 0}), Error);
  EXPECT_THROW(stream(cave, {}, {.discharge = nan}), Error);
  EXPECT_THROW(stream(cave, {}, {.roughness = nan}), Error);
  EXPECT_THROW(stream(cave, {}, {.spacing = 0}), Error);
  EXPECT_THROW(stream_body(cave, {}, {}, {.overlap = nan}), Error);
  EXPECT_THROW(floor_plan(tube_along({{0, 0, 0}, {1e7, 0, 0}}), {}, 0.5), Error);
}

}  // namespace
}  // namespace vug::passages
