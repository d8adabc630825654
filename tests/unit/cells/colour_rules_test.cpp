// SPDX-License-Identifier: Apache-2.0
// The rules of table 1 for spreading and drawing: colours, Voronoi patches, cracks, melting, water.
#include "run.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <queue>
#include <set>

namespace vug::cells {
namespace {

TEST(RandomColor, ColoursItsFractionOfTheCells) {
  const NetworkPtr n = torus(100, 100, 6);
  const Simulation s = ran(n, {stage("random_color", {{"share", 0.2}})}, 1);
  const auto& color = s.attributes().values<Vec3f>("Cd");
  const auto& seed = s.attributes().values<int32_t>("seed");
  double colored = 0, red = 0;
  for (uint32_t i = 0; i < n->size(); ++i) {
    ASSERT_EQ(seed[i] != 0, color[i] != Vec3f(0));
    if (seed[i] == 0) continue;
    ASSERT_EQ(seed[i], static_cast<int32_t>(i) + 1);
    ++colored, red += static_cast<double>(color[i].x);
  }
  EXPECT_NEAR(colored, 2000, 4 * 40);  // Four standard deviations.
  EXPECT_NEAR(red / colored, 0.5, 4 * 0.289 / std::sqrt(colored));
}

// One for each square of 5 m, whatever the spacing.
TEST(RandomColor, HasTheRequestedDistance) {
  for (const double spacing : {0.5, 1.0}) {
    const auto side = static_cast<uint32_t>(100 / spacing);
    const auto n = std::make_shared<const Network>(flat_torus(side, side, 4, spacing));
    const Simulation s = ran(n, {stage("random_color", {{"apart", 5.0}})}, 1);
    const auto& seed = s.attributes().values<int32_t>("seed");
    const auto none = std::count(seed.begin(), seed.end(), 0);
    EXPECT_NEAR(static_cast<double>(n->size()) - static_cast<double>(none), 400, 4 * 20);
  }
}

TEST(RandomColor, LiesOnTheLineBetweenItsColoursOnRequest) {
  const Vec3d from(0.5, 0.1, 0.25), to(0.7, 0.9, 0);
  const Simulation s =
      ran(torus(20, 20, 6),
          {stage("random_color", {{"from", from}, {"to", to}, {"gradient", true}})}, 1);
  std::set<float> ways;
  for (const Vec3f& color : s.attributes().values<Vec3f>("Cd")) {
    const float way = (color.y - 0.1f) / 0.8f;
    ways.insert(way);
    EXPECT_NEAR(color.x, 0.5f + 0.2f * way, 1e-6f);
    EXPECT_NEAR(color.z, 0.25f - 0.25f * way, 1e-6f);
  }
  EXPECT_GT(ways.size(), 390u);
}

TEST(SpreadingColor, IsTheMeanOfColouredCellsAndConservesColour) {
  // One coloured cell: its neighbours get half of it, as (0 + c) / (1 + 1).
  Simulation one(torus(8, 8, 4), RandomKey(1));
  one.attributes().column<Vec3f>("Cd").now[27] = Vec3f(1, 0.5f, 0.25f);
  one.run({stage("spreading_color")}, 1);
  for (uint32_t i = 0; i < 64; ++i) {
    const bool beside = i == 26 || i == 28 || i == 19 || i == 35;
    const Vec3f expected = Vec3f(1, 0.5f, 0.25f) * (i == 27 ? 1.0f : beside ? 0.5f : 0.0f);
    EXPECT_EQ(one.attributes().values<Vec3f>("Cd")[i], expected) << i;
  }
  const NetworkPtr n = uneven();
  Simulation all(n, RandomKey(2));
  all.run({stage("random_color")}, 1);
  const Vec3d before = weighted_sum(*n, all.attributes().values<Vec3f>("Cd"));
  all.run({stage("spreading_color")}, 50);
  const Vec3d after = weighted_sum(*n, all.attributes().values<Vec3f>("Cd"));
  EXPECT_LT((after - before).length(), 1e-5 * before.length());
}

/// The smallest of the seeds with the fewest links in between, by a search from every seed.
std::vector<int32_t> nearest_seeds(const Network& n, const std::vector<int32_t>& seeds) {
  std::vector<uint32_t> distance(n.size(), ~0u);
  std::vector<int32_t> nearest(n.size(), 0);
  for (uint32_t s = 0; s < n.size(); ++s) {
    if (seeds[s] == 0) continue;
    std::vector<uint32_t> away(n.size(), ~0u);
    std::queue<uint32_t> queue;
    away[s] = 0, queue.push(s);
    for (; !queue.empty(); queue.pop()) {
      const uint32_t i = queue.front();
      if (away[i] < distance[i]) distance[i] = away[i], nearest[i] = seeds[s];
      for (const uint32_t to : n.links.of(i))
        if (away[to] == ~0u) away[to] = away[i] + 1, queue.push(to);
    }
  }
  return nearest;
}

TEST(Voronoi, AndCracksEqualBruteForce) {
  for (const NetworkPtr& n : {uneven(), torus(60, 40, 4), torus(60, 40, 6)}) {
    Simulation s(n, RandomKey(3));
    s.run({stage("random_color", {{"share", 0.01}})}, 1);
    const std::vector<int32_t> expected = nearest_seeds(*n, s.attributes().values<int32_t>("seed"));
    s.run({stage("voronoi")}, 100);
    EXPECT_EQ(s.attributes().values<int32_t>("seed"), expected);
    const std::vector<Vec3f> color = s.attributes().values<Vec3f>("Cd");
    s.run({stage("crack")}, 5);  // Further steps produce no more cracks.
    size_t cracks = 0;
    for (uint32_t i = 0; i < n->size(); ++i) {
      bool border = false;
      for (const uint32_t to : n->links.of(i)) border |= expected[to] != expected[i];
      ASSERT_EQ(s.attributes().values<float>("crack")[i], border ? 1 : 0);
      ASSERT_EQ(s.states()[i], border ? CellState::sleeping : CellState::active);
      ASSERT_EQ(s.attributes().values<Vec3f>("Cd")[i] == color[i], !border);
      cracks += border;
    }
    EXPECT_GT(cracks, n->size() / 20);
    EXPECT_LT(cracks, n->size() / 2);
  }
}

TEST(Melting, LowersTheEnergyOfTheSurfaceInEveryStep) {
  const NetworkPtr n = uneven();
  // The energy of springs along the links. In terms of the eigenvectors of the mean over a cell and
  // its neighbours, each step reduces every component, and all are positive.
  const auto energy = [&](const std::vector<Vec3f>& p) {
    double sum = 0;
    for (uint32_t i = 0; i < n->size(); ++i)
      for (const uint32_t to : n->links.of(i)) sum += Vec3d(p[to] - p[i]).length2();
    return sum;
  };
  Simulation s(n, RandomKey(4));
  double last = energy(n->position);
  const Vec3d centre = weighted_sum(*n, n->position);
  for (int step = 0; step < 40; ++step) {
    s.run({stage("melting")}, 1);
    const double now = energy(s.attributes().values<Vec3f>("P"));
    ASSERT_LT(now, last) << step;
    last = now;
  }
  EXPECT_LT(last, 0.9 * energy(n->position));
  EXPECT_LT((weighted_sum(*n, s.attributes().values<Vec3f>("P")) - centre).length(),
            1e-5 * static_cast<double>(n->size()));
  for (const Vec3f& normal : s.attributes().values<Vec3f>("N"))
    ASSERT_NEAR(normal.length(), 1, 1e-5);
}

TEST(Watercolor, ConservesWaterWithoutDryingAndDryPigment) {
  const NetworkPtr n = uneven();
  const std::vector<Stage> begin = {
      stage("random_color"),
      stage("sprinkle", {{"attribute", "wetness"}, {"share", 0.3}, {"value", 0.8}})};
  Simulation wet = ran(n, begin, 1);
  const double water = weighted_sum(*n, wet.attributes().values<float>("wetness"));
  wet.run({stage("watercolor", {{"loss", 0}})}, 60);
  EXPECT_NEAR(weighted_sum(*n, wet.attributes().values<float>("wetness")) / water, 1, 1e-5);

  // Every cell of a torus is wet: each step removes the loss from each, then all is dry and
  // constant.
  const NetworkPtr flat = torus(30, 30, 6);
  Simulation dry(flat, RandomKey(5));
  dry.attributes().column<float>("wetness", 0.5f);
  dry.run({stage("random_color")}, 1);
  dry.run({stage("watercolor", {{"loss", 0.125}})}, 3);
  for (const float w : dry.attributes().values<float>("wetness")) ASSERT_NEAR(w, 0.125, 1e-6);
  dry.run({stage("watercolor", {{"loss", 0.125}})}, 2);
  const std::vector<Vec3f> pigment = dry.attributes().values<Vec3f>("Cd");
  dry.run({stage("watercolor", {{"loss", 0.125}})}, 5);
  for (const float w : dry.attributes().values<float>("wetness")) ASSERT_EQ(w, 0);
  EXPECT_EQ(dry.attributes().values<Vec3f>("Cd"), pigment);
  // It mixed before: at half wetness, a cell moves half the way to its neighbours' mean.
  EXPECT_NE(pigment, ran(flat, {stage("random_color")}, 1, 5).attributes().values<Vec3f>("Cd"));
}

}  // namespace
}  // namespace vug::cells
