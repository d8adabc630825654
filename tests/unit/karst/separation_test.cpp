// SPDX-License-Identifier: Apache-2.0
// Passages meet at stations or keep apart.
#include "caves.h"

#include <gtest/gtest.h>
#include <vug/base/disjoint_sets.h>
#include <vug/base/rng.h>
#include <vug/karst/segment_grid.h>
#include <vug/karst/separation.h>

#include <cmath>

namespace vug::karst {
namespace {

Vec3d random_vector(RandomStream& random, double reach) {
  const double x = random.uniform(-reach, reach);
  const double y = random.uniform(-reach, reach);
  return {x, y, random.uniform(-reach, reach)};
}

SegmentPiece random_segment(RandomStream& random, double reach) {
  const Vec3d from = random_vector(random, reach);
  return {from, from + random_vector(random, 2)};
}

TEST(SegmentDistance, IsTheLeastBetweenTheirPoints) {
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 200; ++i) {
    const SegmentPiece a = random_segment(random, 3);
    SegmentPiece b = random_segment(random, 3);
    if (i % 5 == 0) b.to = b.from;                          // A point.
    if (i % 5 == 1) b.to = b.from + (a.to - a.from) * 0.7;  // Parallel.
    constexpr int kSteps = 100;
    double least = kInfinity;
    for (int s = 0; s <= kSteps; ++s)
      for (int t = 0; t <= kSteps; ++t) {
        const Vec3d on_a = a.from + (a.to - a.from) * (1.0 * s / kSteps);
        const Vec3d on_b = b.from + (b.to - b.from) * (1.0 * t / kSteps);
        least = std::min(least, (on_a - on_b).length());
      }
    const double distance = std::sqrt(distance2(a, b));
    EXPECT_LE(distance, least + 1e-12);
    EXPECT_GT(distance, least - 0.04);
    EXPECT_DOUBLE_EQ(distance2(a, b), distance2(b, a));
  }
}

TEST(SegmentGrid, FindsAllWithinItsReach) {
  RandomStream random(RandomKey(6));
  std::vector<SegmentPiece> segments;
  SegmentGrid grid(1.5, 0.8);
  for (int i = 0; i < 150; ++i) {
    segments.push_back(random_segment(random, 6));
    grid.add(i, segments.back());
  }
  for (const SegmentPiece& segment : segments) {
    std::vector<bool> found(segments.size(), false);
    grid.any_near(segment, [&](int other) {
      found[static_cast<size_t>(other)] = true;
      return false;
    });
    for (size_t i = 0; i < segments.size(); ++i)
      if (distance2(segment, segments[i]) < 0.8 * 0.8) {
        EXPECT_TRUE(found[i]);
      }
  }
}

/// The metres along the network from any end of one leg to any end of another one, or infinity
/// above a limit.
double way_between(const network::Network& cave, const std::vector<std::vector<int>>& legs_at,
                   const network::Leg& a, const network::Leg& b, double limit) {
  std::vector<std::pair<double, int>> open{{0, a.from}, {0, a.to}};
  std::vector<int> closed;
  while (!open.empty()) {
    const auto next = std::min_element(open.begin(), open.end());
    const auto [metres, station] = *next;
    open.erase(next);
    if (metres > limit) break;
    if (station == b.from || station == b.to) return metres;
    if (std::find(closed.begin(), closed.end(), station) != closed.end()) continue;
    closed.push_back(station);
    for (const int index : legs_at[static_cast<size_t>(station)]) {
      const network::Leg& leg = cave.legs[static_cast<size_t>(index)];
      const int other = leg.from == station ? leg.to : leg.from;
      open.emplace_back(metres + leg_vector(cave, leg).length(), other);
    }
  }
  return kInfinity;
}

TEST(Separation, LegsThatAreCloseAreNeighbours) {
  for (const Preset& preset : presets()) {
    KarstOptions options = preset.options;
    options.samples.count = 2000;
    const network::Network cave = generate(preset.geology, options);
    const auto legs_at = network::legs_at_stations(cave);
    const auto segment = [&](const network::Leg& leg) {
      return SegmentPiece{cave.stations[static_cast<size_t>(leg.from)].position,
                          cave.stations[static_cast<size_t>(leg.to)].position};
    };
    SegmentGrid grid(10, 2);
    int close = 0;
    for (size_t i = 0; i < cave.legs.size(); ++i) {
      grid.any_near(segment(cave.legs[i]), [&](int index) {
        const network::Leg& other = cave.legs[static_cast<size_t>(index)];
        const double apart = std::sqrt(distance2(segment(cave.legs[i]), segment(other)));
        if (apart < options.samples.separation - 1e-9 &&
            way_between(cave, legs_at, cave.legs[i], other, 10) == kInfinity)
          ++close;
        return false;
      });
      grid.add(static_cast<int>(i), segment(cave.legs[i]));
    }
    EXPECT_EQ(close, 0) << preset.name;
  }
}

TEST(Separation, KeepsTheCheaperOfCrossingEdgesAndKeyPointsTogether) {
  SampleGraph graph;
  graph.points = {Vec3d(0, 0, 0), Vec3d(20, 0, 0), Vec3d(20, 0, 20), Vec3d(0, 0, 20)};
  graph.edges = {{0, 1}, {0, 2}, {1, 2}, {1, 3}, {2, 3}};
  graph.cost = {1, 8, 1, 7, 1};
  const SampleGraph kept = separated(graph, 0, 2);
  EXPECT_EQ(kept.edges, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}, {1, 3}, {2, 3}}));
  EXPECT_EQ(kept.cost, (std::vector<double>{1, 1, 7, 1}));
  EXPECT_EQ(kept.first.back(), 8);
  // Edges that are the only ways to key points remain, others do not.
  graph.edges = {{0, 1}, {0, 2}, {1, 3}};
  graph.cost = {1, 2, 3};
  EXPECT_EQ(separated(graph, 4, 2).edges.size(), 3U);
  EXPECT_EQ(separated(graph, 3, 2).edges, (std::vector<std::array<int, 2>>{{0, 1}, {0, 2}}));
}

TEST(Separation, MergesNearlyParallelEdgesAtAStation) {
  SampleGraph graph;
  graph.points = {Vec3d(0, 0, 0), Vec3d(20, 0, 0), Vec3d(40, 0, 8)};
  graph.edges = {{0, 1}, {0, 2}, {1, 2}};
  graph.cost = {1, 3, 1};
  EXPECT_EQ(separated(graph, 0, 2).edges, (std::vector<std::array<int, 2>>{{0, 1}, {1, 2}}));
}

TEST(Separation, CoincidentKeyPointsAreOneStation) {
  Geology geology = small_geology();
  geology.entrances = {geology.sinks[0].position, geology.sinks[0].position + Vec3d(0.5, 0, 0)};
  const network::Network cave = generate(geology, small_options());
  EXPECT_GE(station_named(cave, "entrance.2"), 0);
}

}  // namespace
}  // namespace vug::karst
