// SPDX-License-Identifier: Apache-2.0
// Draperies hang where the roof slopes, from the ways of their water.
#include <vug/drips/dripstone.h>

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "rooms.h"

namespace vug::drips {
namespace {

std::vector<HungDrapery> hung_below(double degrees, const DraperyOptions& o) {
  GraphOptions graph = graph_options(3);
  graph.run_out = false;
  graph.spacing = 0.25;
  graph.density = 1;
  graph.oldest = 30000;
  const field::Field rock = hall(6, std::tan(degrees * kPi / 180), 6);
  return draperies_of(rock, build_graph(rock, graph), o);
}

TEST(Draperies, HangBelowSlopingRoofsOnly) {
  const DraperyOptions all{.share = 1};
  const size_t level = hung_below(3, all).size(), sloping = hung_below(42, all).size(),
               wall = hung_below(79, all).size();
  EXPECT_EQ(level, 0u);
  EXPECT_GT(sloping, 15u);
  EXPECT_EQ(wall, 0u);
  EXPECT_EQ(hung_below(42, {.share = 0}).size(), 0u);
  const size_t half = hung_below(42, {.share = 0.5}).size();
  EXPECT_GT(half, 0u);
  EXPECT_LT(half, sloping);
}

TEST(Draperies, ShareFollowsTheSlope) {
  EXPECT_EQ(drapery_share(0.1), 0);
  EXPECT_EQ(drapery_share(45 * kPi / 180), 1);
  EXPECT_EQ(drapery_share(80 * kPi / 180), 0);
}

TEST(Draperies, KeepToTheRoofAndToTheWaysOfTheirWater) {
  const DraperyOptions o{.share = 1, .floor = -3};
  const field::Field rock = hall(6, std::tan(40 * kPi / 180), 6);
  std::set<int64_t> ids;
  for (const HungDrapery& drapery : hung_below(40, o)) {
    EXPECT_TRUE(ids.insert(drapery.drip).second) << "one for each seep";
    const field::Drapery& sheet = drapery.sheet;
    for (size_t i = 0; i < sheet.path.size(); ++i) {
      const field::Gradient g = rock.gradient(sheet.path[i]);
      EXPECT_NEAR(g.value, 0, 0.003) << "the root lies on the roof";
      if (i == 0) continue;
      const Vec3d way = sheet.path[i] - sheet.path[i - 1];
      EXPECT_LT(way.y, 0) << "water runs down";
      EXPECT_LT(std::fabs(way.dot(g.gradient.normalized())), 0.003) << "along the roof";
    }
    EXPECT_NEAR(sheet.edge, 0.0051, 2e-4);
    // It ends above the floor.
    const field::Field solid = drapery_fields({drapery}, o)[0];
    EXPECT_GT(solid.bounds().min.y, -1.99);
    EXPECT_LE(sheet.width, 1.4);
    EXPECT_GE(solid.node()->traits().growth_rate(), kDripstoneGrowth);
  }
  EXPECT_GT(ids.size(), 15u);
}

}  // namespace
}  // namespace vug::drips
