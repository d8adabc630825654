// SPDX-License-Identifier: Apache-2.0
// Axes of passages: chains of legs, walls without measurements, smooth curves, meanders, frames and
// sections from splays.
#include "passage_samples.h"

#include <vug/base/error.h>
#include <vug/base/maths.h>
#include <vug/passages/curves/chains.h>
#include <vug/passages/curves/frames.h>
#include <vug/passages/curves/meander.h>
#include <vug/passages/curves/smooth.h>
#include <vug/passages/curves/splay_section.h>
#include <vug/passages/curves/star_outline.h>
#include <vug/passages/curves/walls.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::passages {
namespace {

TEST(Chains, TheStraightestLegsContinueEachOther) {
  // A passage along x with a side passage at station 1, whose leg comes first.
  const auto network =
      network_of({{0, 0, 0}, {10, 0, 0}, {20, 0, 1}, {10, 0, 10}}, {{1, 3}, {0, 1}, {1, 2}});
  const std::vector<Chain> all = chains(network);
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all[0].stations, (std::vector<int>{1, 3}));
  EXPECT_TRUE(all[0].start_meets);
  EXPECT_FALSE(all[0].end_meets);
  EXPECT_EQ(all[1].stations, (std::vector<int>{0, 1, 2}));
  EXPECT_FALSE(all[1].start_meets || all[1].end_meets);
}

TEST(Chains, ARingIsOnePassageWithoutMeetings) {
  const auto ring = network_of({{0, 0, 0}, {10, 0, 0}, {10, 0, 10}, {0, 0, 10}},
                               {{0, 1}, {1, 2}, {2, 3}, {3, 0}});
  const std::vector<Chain> all = chains(ring);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].legs.size(), 4u);
  EXPECT_FALSE(all[0].start_meets || all[0].end_meets);
}

TEST(Chains, EveryLegBelongsToOnePassage) {
  const auto network = random_cave(5, 300);
  std::vector<int> uses(network.legs.size(), 0);
  for (const Chain& chain : chains(network)) {
    ASSERT_EQ(chain.stations.size(), chain.legs.size() + 1);
    for (const int leg : chain.legs) ++uses[static_cast<size_t>(leg)];
  }
  EXPECT_TRUE(std::all_of(uses.begin(), uses.end(), [](int n) { return n == 1; }));
}

TEST(Chains, RepeatedAndEmptyLegsAreOmitted) {
  const auto network = network_of({{0, 0, 0}, {10, 0, 0}, {10, 0, 0}, {20, 0, 0}},
                                  {{0, 1}, {1, 0}, {1, 2}, {2, 3}, {1, 3}});
  const std::vector<Chain> all = chains(network);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].legs, (std::vector<int>{0, 3}));
}

TEST(Walls, GapsAreInterpolatedAndTurnedIntoTheChain) {
  auto network =
      network_of({{0, 0, 0}, {10, 0, 0}, {20, 0, 0}, {30, 0, 0}}, {{0, 1}, {1, 2}, {3, 2}});
  network.stations[0].section = network::CrossSection{1, 2, 3, {}};
  network.stations[2].section = network::CrossSection{3, 2, 1, {}};
  network.stations[3].section = network::CrossSection{5, 6, 1, {}};
  const std::vector<Chain> all = chains(network);
  ASSERT_EQ(all.size(), 1u);
  const std::vector<Walls> walls = walls_along(network, all[0], {4, 8, 0.5});
  EXPECT_NEAR(walls[1].left, 0.5 * (1 + walls[2].left), 1e-12);
  EXPECT_NEAR(walls[1].up, 2, 1e-12);
  EXPECT_FALSE(walls[1].measured);
  EXPECT_NEAR(walls[1].down, 4, 1e-12);  // Half of the default height.
  // The last leg was surveyed against the passage, so its left is the right of the passage.
  EXPECT_EQ(walls[3].left, 6);
  EXPECT_EQ(walls[3].right, 5);
}

TEST(Walls, SmallSizesAreRaised) {
  auto network = with_radius(network_of({{0, 0, 0}, {10, 0, 0}}, {{0, 1}}), 0);
  const Walls walls = walls_along(network, chains(network)[0], {4, 8, 0.5})[0];
  EXPECT_NEAR(walls.width(), 0.5, 1e-12);
  EXPECT_NEAR(walls.height(), 0.5, 1e-12);
}

Curve zigzag(double angle, double leg, double width) {
  Curve curve;
  Vec3d at(0.0);
  for (int i = 0; i < 12; ++i) {
    CurvePoint p;
    p.position = at;
    p.width = p.height = width;
    p.station = i;
    p.fixed = i == 0 || i == 11;
    curve.push_back(p);
    const double heading = i % 2 == 0 ? angle : -angle;
    at += Vec3d(std::cos(heading), 0.1, std::sin(heading)) * leg;
  }
  return curve;
}

TEST(Smoothed, BendsAreLimitedAndStationsStayInside) {
  const Curve line = zigzag(0.6, 6, 3);
  const Curve curve = smoothed(line, {});
  EXPECT_GT(curve.size(), line.size());
  EXPECT_EQ(curve.front().position, line.front().position);
  EXPECT_EQ(curve.back().position, line.back().position);
  const std::vector<double> bends = curvatures(curve);
  for (size_t i = 0; i < curve.size(); ++i) {
    EXPECT_LE(bends[i] * 0.5 * curve[i].width, 0.82) << i;
    if (curve[i].station >= 0) {
      const Vec3d& p = line[static_cast<size_t>(curve[i].station)].position;
      EXPECT_LE((curve[i].position - p).length(), 1.5 + 1e-9);
    }
  }
}

TEST(Smoothed, AStraightPassageStaysOneSegmentForEachLeg) {
  const Curve line = zigzag(0, 6, 3);
  EXPECT_EQ(smoothed(line, {}).size(), line.size());
}

TEST(Meanders, TheAmplitudeGivesTheSinuosity) {
  // 1 / J0 of tables of Bessel functions.
  EXPECT_NEAR(meander_amplitude(1.0656), 0.5, 1e-3);
  EXPECT_NEAR(meander_amplitude(1.3069), 1, 1e-3);
  EXPECT_NEAR(meander_amplitude(1.9538), 1.5, 1e-3);
}

TEST(Meanders, LengthAndWavelengthAreThoseAskedFor) {
  Curve line(2);
  line[1].position = {220, 0, 0};
  line[0].width = line[1].width = 2;
  line[0].fixed = line[1].fixed = true;
  for (const double sinuosity : {1.2, 1.5, 2.5}) {
    const Curve curve = meandered(line, {sinuosity, 11});
    EXPECT_NEAR(arc_lengths(curve).back() / 220, sinuosity, 0.01 * sinuosity);
    EXPECT_EQ(curve.back().position, line[1].position);
    int crossings = 0;
    double side = 0;
    for (const CurvePoint& p : curve) {
      if (std::fabs(p.position.z) < 1e-6) continue;
      crossings += p.position.z * side < 0;
      side = p.position.z;
    }
    EXPECT_EQ(crossings, 19);  // Half waves of 11 m: one crossing between two of them.
  }
}

TEST(Meanders, PhreaticAndSteepPassagesStayStraight) {
  Curve line(2);
  line[1].position = {100, 0, 0};
  line[0].stage = network::Stage::phreatic;
  EXPECT_EQ(meandered(line, {1.5, 11}).size(), 2u);
  line[0].stage = network::Stage::vadose;
  line[1].position = {10, -100, 0};
  EXPECT_EQ(meandered(line, {1.5, 11}).size(), 2u);
}

TEST(Frames, AreUprightWhereLevelAndDoNotSpinWhereSteep) {
  // A shaft between two level passages in opposite directions, with rounded bends.
  std::vector<Vec3d> points, directions;
  for (int i = 0; i <= 60; ++i) {
    const double angle = kPi * i / 60;
    points.push_back({10 * std::sin(angle), 10 * std::cos(angle), 0.01 * i});
  }
  for (size_t i = 0; i < points.size(); ++i)
    directions.push_back(
        (points[std::min(i + 1, points.size() - 1)] - points[i > 0 ? i - 1 : 0]).normalized());
  const std::vector<Frame> all = frames(points, directions);
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_NEAR(all[i].right.length(), 1, 1e-9);
    EXPECT_NEAR(all[i].right.dot(directions[i]), 0, 1e-9);
    EXPECT_NEAR((all[i].right.cross(directions[i]) - all[i].up).length(), 0, 1e-9);
    if (std::fabs(directions[i].y) < 0.76) {
      EXPECT_GT(all[i].up.y, 0.6) << i;
    }
  }
}

TEST(Splays, TheOutlinePassesThroughTheHits) {
  const Frame frame{{1, 0, 0}, {0, 1, 0}};
  std::vector<Vec3d> ends;
  for (int i = 0; i < 12; ++i) {
    const double angle = 2 * kPi * i / 12 - 3.1;
    const double radius = 2 + std::sin(3 * angle);
    ends.push_back(Vec3d(5, 6, 7) + Vec3d(std::cos(angle), std::sin(angle), 0.2) * radius);
  }
  ends.push_back({5, 6, 12});    // Along the passage: not a wall of this section.
  ends.push_back({30, 6.5, 7});  // Across a chamber: too long.
  const SectionPtr section = splay_section(ends, {5, 6, 7}, frame, {});
  ASSERT_TRUE(section);
  for (size_t i = 0; i < 12; ++i)
    EXPECT_NEAR(section->distance(ends[i].x - 5, ends[i].y - 6), 0, 0.02) << i;
  EXPECT_LT(section->distance(0, 0), -0.8);
}

TEST(Splays, WideGapsFollowTheMeasuredWalls) {
  const Frame frame{{1, 0, 0}, {0, 1, 0}};
  const std::vector<Vec3d> ends{{2, 0, 0}, {1.5, 1.5, 0}, {0, 2, 0}, {-1.5, 1.5, 0}, {-2, 0, 0}};
  Walls walls;
  walls.left = walls.right = walls.up = 2;
  walls.down = 1;
  const SectionPtr section = splay_section(ends, {0, 0, 0}, frame, walls);
  ASSERT_TRUE(section);
  EXPECT_NEAR(section->distance(0, -1), 0, 0.03);
  EXPECT_EQ(splay_section({{2, 0, 0}, {0, 2, 0}}, {0, 0, 0}, frame, walls), nullptr);
}

TEST(Splays, OutlinesBlendByTheirRadii) {
  const SectionPtr ellipse = make_family("tube")->fit({.width = 2, .height = 6});
  const SectionPtr circle = make_family("tube")->fit({.width = 4, .height = 4});
  const StarOutline narrow = star_outline(*ellipse), round = star_outline(*circle);
  for (const double radius : round) EXPECT_NEAR(radius, 2, 1e-5);
  EXPECT_NEAR(narrow[0], 1, 1e-5);
  EXPECT_NEAR(narrow[narrow.size() / 4], 3, 1e-5);
  const SectionPtr middle = blended_section(narrow, round, 0.5);
  EXPECT_NEAR(middle->distance(1.5, 0), 0, 1e-5);
  EXPECT_NEAR(middle->distance(0, -2.5), 0, 1e-5);
}

// A cone about the x axis, surveyed along a line 1 m next to it.
TEST(Splays, WallsBetweenStationsAreThoseOfBothStations) {
  network::Network network = network_of({{0, 0, -1}, {8, 0, -1}, {16, 0, -1}}, {{0, 1}, {1, 2}});
  const auto on_wall = [](double x, double radius, double angle) {
    return Vec3d(x, radius * std::cos(angle), radius * std::sin(angle));
  };
  for (size_t i = 0; i < 3; ++i)
    for (int k = 0; k < 32; ++k)
      network.stations[i].splays.push_back(
          on_wall(8.0 * static_cast<double>(i), 2 + 0.4 * static_cast<double>(i), kPi * k / 16));
  const field::Field air = passages(network);
  for (const double angle : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    EXPECT_NEAR(air.value(on_wall(4, 2.2, angle)), 0, 0.06) << angle;
    EXPECT_NEAR(air.value(on_wall(8, 2.4, angle)), 0, 0.03) << angle;
    EXPECT_NEAR(air.value(on_wall(12, 2.6, angle)), 0, 0.06) << angle;
  }
}

TEST(Passages, InvalidNetworksAreRefused) {
  EXPECT_THROW(passages({}), Error);
  EXPECT_THROW(passages(network_of({{0, 0, 0}}, {})), Error);
  EXPECT_THROW(passages(network_of({{0, 0, 0}, {1, 0, 0}}, {{0, 2}})), Error);
  EXPECT_THROW(passages(network_of({{0, 0, 0}, {1, 0, 0}}, {{-1, 0}})), Error);
  EXPECT_THROW(passages(network_of({{0, 0, 0}, {1, std::nan(""), 0}}, {{0, 1}})), Error);
  EXPECT_THROW(passages(network_of({{0, 0, 0}, {0, 0, 0}}, {{0, 1}})), Error);  // No length.
  EXPECT_THROW(passages(with_radius(network_of({{0, 0, 0}, {9, 0, 0}}, {{0, 1}}), -1)), Error);
  EXPECT_THROW(passages(with_radius(network_of({{0, 0, 0}, {9, 0, 0}}, {{0, 1}}), kInfinity)),
               Error);
  const auto network = network_of({{0, 0, 0}, {9, 0, 0}}, {{0, 1}});
  for (const double bad : {0.0, -1.0, kInfinity, std::nan("")}) {
    PassageOptions options;
    options.size.width = bad;
    EXPECT_THROW(passages(network, options), Error);
  }
  PassageOptions options;
  options.chamber = 0.5;
  EXPECT_THROW(passages(network, options), Error);
  options = {};
  options.fillet = 2;
  EXPECT_THROW(passages(network, options), Error);
  options = {};
  options.meanders.sinuosity = 9;
  EXPECT_THROW(passages(network, options), Error);
}

}  // namespace
}  // namespace vug::passages
