// SPDX-License-Identifier: Apache-2.0
// Growth on rock and its erosion: moss, lichens, crusts, erosion; and cells that freeze.
#include "run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <queue>
#include <set>

namespace vug::cells {
namespace {

/// Number of links to the nearest of the given cells; -1 if unreachable.
std::vector<int> links_from(const Network& n, const std::vector<uint32_t>& cells) {
  std::vector<int> away(n.size(), -1);
  std::queue<uint32_t> queue;
  for (const uint32_t i : cells) away[i] = 0, queue.push(i);
  for (; !queue.empty(); queue.pop())
    for (const uint32_t to : n.links.of(queue.front()))
      if (away[to] < 0) away[to] = away[queue.front()] + 1, queue.push(to);
  return away;
}

NetworkPtr sheet(double spacing) {
  mesh::Mesh mesh = floor_mesh();
  const Surface surface({shared(std::move(mesh))});
  return std::make_shared<const Network>(build(surface, options("triangle", spacing)).network);
}

TEST(Moss, GrowsFromItsSeedsWherePossible) {
  const NetworkPtr n = sheet(0.01);
  Simulation s(n, RandomKey(1));
  auto& moist = s.attributes().column<float>("moisture", 1).now;
  for (uint32_t i = 0; i < n->size(); ++i) moist[i] = n->position[i].x < 0.7f ? 1.0f : 0.2f;
  const double seeds = 200;
  const NamedValues parameters = {{"seeds", seeds}, {"thickness", 0.01}};
  s.run({stage("moss", parameters)}, 1);
  const auto grown = [&](const Simulation& at) {
    std::vector<uint32_t> cells;
    for (uint32_t i = 0; i < n->size(); ++i)
      if (at.attributes().values<float>("moss")[i] > 0) cells.push_back(i);
    return cells;
  };
  const std::vector<uint32_t> first = grown(s);
  EXPECT_NEAR(static_cast<double>(first.size()), 0.7 * seeds, 4 * std::sqrt(0.7 * seeds));
  const int steps = 12;
  const std::vector<int> away = links_from(*n, first);
  std::vector<float> before = s.attributes().values<float>("moss");
  for (int step = 1; step < steps; ++step) {
    s.run({stage("moss", parameters)}, 1);
    const auto& moss = s.attributes().values<float>("moss");
    for (uint32_t i = 0; i < n->size(); ++i) {
      ASSERT_GE(moss[i], before[i]);
      ASSERT_LE(moss[i], 1);
      if (moss[i] > 0) {
        ASSERT_LE(away[i], step);
        ASSERT_LT(n->position[i].x, 0.7f);
      }
      ASSERT_NEAR(s.attributes().values<float>("height")[i], 0.01f * moss[i], 1e-7);
      ASSERT_EQ(moss[i] > 0, s.attributes().values<Vec3f>("Cd")[i] != Vec3f(0));
    }
    before = moss;
  }
  EXPECT_GT(grown(s).size(), 4 * first.size());
}

TEST(Moss, CoverageDoesNotDependOnTheSpacing) {
  const auto share = [](double spacing) {
    const NetworkPtr n = sheet(spacing);
    const Simulation s = ran(n, {stage("moss", {{"seeds", 60}, {"speed", 0.004}})}, 15, 3);
    double area = 0;
    for (uint32_t i = 0; i < n->size(); ++i)
      area += s.attributes().values<float>("moss")[i] > 0 ? static_cast<double>(n->area[i]) : 0;
    return area;
  };
  const double coarse = share(0.012), fine = share(0.006);
  EXPECT_GT(coarse, 0.1);
  EXPECT_NEAR(fine / coarse, 1, 0.35);  // Of 60 clumps, whose number alone varies by 13 %.
}

TEST(Lichen, RosettesAreRoundAndKeepTheirColours) {
  const NetworkPtr n = sheet(0.005);
  const std::vector<Vec3d> colors = {{0.5, 0, 0}, {0, 0.5, 0}};
  const NamedValues parameters = {{"seeds", 30},
                                  {"size", 0.1},
                                  {"lobes", 0},
                                  {"rim", 0},
                                  {"speed", 0.002},
                                  {"colors", List{colors[0], colors[1]}},
                                  {"line", Vec3d(0, 0, 0.25)}};
  const Simulation s = ran(n, {stage("lichen", parameters)}, 60);
  const auto& colony = s.attributes().values<int32_t>("colony");
  const auto& color = s.attributes().values<Vec3f>("Cd");
  const auto& cover = s.attributes().values<float>("lichen");
  std::set<int32_t> seeds;
  size_t lines = 0, covered = 0;
  for (uint32_t i = 0; i < n->size(); ++i) {
    ASSERT_EQ(colony[i] == 0, cover[i] == 0);
    if (colony[i] == 0) continue;
    seeds.insert(colony[i]);
    ++covered;
    const auto seed = static_cast<uint32_t>(colony[i] - 1);
    ASSERT_EQ(colony[seed], colony[i]);
    ASSERT_LT((n->position[i] - n->position[seed]).length(), 0.1f);
    bool border = false;
    for (const uint32_t to : n->links.of(i)) border |= colony[to] != 0 && colony[to] != colony[i];
    if (cover[i] < 1) {
      ASSERT_TRUE(border);
      ASSERT_EQ(color[i], Vec3f(0, 0, 0.25f));
      ++lines;
    } else {
      const bool red = color[i].x > 0.3f && color[i].y == 0;
      const bool green = color[i].y > 0.3f && color[i].x == 0;
      ASSERT_TRUE(red || green) << color[i].x << " " << color[i].y;
    }
    // Roundness: a cell nearer to the centre, within the irregularity of the rim, belongs to this
    // or another rosette.
    for (const uint32_t to : n->links.of(i)) {
      if (colony[to] != 0) continue;
      const float here = (n->position[i] - n->position[seed]).length();
      const float there = (n->position[to] - n->position[seed]).length();
      ASSERT_GT(there, here - 0.6f * 0.005f - 0.005f) << i;
    }
  }
  EXPECT_NEAR(static_cast<double>(seeds.size()), 30, 4 * std::sqrt(30.0));
  EXPECT_GT(lines, 0u);
  EXPECT_GT(covered, n->size() / 20);
  EXPECT_NEAR(total(s, "height"), 0.002 * total(s, "lichen"), 1e-4 * total(s, "lichen"));
}

TEST(Crust, ThickensTowardsItsLimitAndSmoothingConserves) {
  const NetworkPtr n = uneven();
  Simulation even =
      ran(n, {stage("crust", {{"lumps", 0}, {"growth", 0.001}, {"limit", 0.01}})}, 20);
  for (const float crust : even.attributes().values<float>("crust"))
    ASSERT_NEAR(crust, 0.01 * (1 - std::pow(0.9, 20)), 1e-6);

  Simulation s(n, RandomKey(2));
  s.run({stage("sprinkle", {{"attribute", "water"}, {"value", 0.15}, {"share", 0.3}})}, 1);
  s.attributes().column<float>("height", 0.5f);
  const double water = total(s, "water");
  s.run({stage("crust", {{"lumps", 0}, {"smooth", 0.5}, {"growth", 1e-4}, {"limit", 1e6}})}, 50);
  EXPECT_NEAR(total(s, "crust") / (50 * 1e-4 * water / 0.3), 1, 1e-4);
  for (uint32_t i = 0; i < n->size(); ++i)
    ASSERT_NEAR(s.attributes().values<float>("height")[i],
                0.5 + static_cast<double>(s.attributes().values<float>("crust")[i]), 1e-5);
}

TEST(Erosion, CarvedVolumeEqualsTransportedVolume) {
  const NetworkPtr n = uneven();
  Simulation s(n, RandomKey(3));
  auto& hard = s.attributes().column<float>("hardness").now;
  for (uint32_t i = 0; i < n->size(); ++i) hard[i] = n->position[i].x > 0 ? 1.0f : 0.0f;
  s.run({stage("run_off", {{"speed", 0.1}}),
         stage("erosion", {{"speed", 0.1}, {"wear", 0.002}, {"depth", 0.03}})},
        60);
  const double carved = total(s, "carved");
  EXPECT_GT(carved, 0.1);
  EXPECT_NEAR((total(s, "sediment") + total(s, "washed")) / carved, 1, 1e-4);
  EXPECT_NEAR(total(s, "height") / carved, -1, 1e-4);
  float deepest = 0;
  for (uint32_t i = 0; i < n->size(); ++i) {
    const float depth = s.attributes().values<float>("carved")[i];
    ASSERT_LE(depth, 0.03f * 1.00001f);
    ASSERT_GE(depth, -0.03f * 1.00001f);
    if (n->normal[i].y < 0) {
      ASSERT_GE(depth, 0);  // Nothing is deposited on overhangs.
    }
    if (hard[i] > 0) {
      ASSERT_LE(depth, 0);  // It may be buried.
    }
    deepest = std::max(deepest, depth);
  }
  EXPECT_GT(deepest, 0.005f);
}

TEST(Freeze, LeavesOtherCellsRunning) {
  // Figure 12, a cascade: sufficiently wet cells are frozen, and the visible state continues to
  // spread.
  const NetworkPtr n = torus(20, 20, 4);
  for (const auto& [as, expected] : std::vector<std::pair<std::string, CellState>>{
           {"sleeping", CellState::sleeping}, {"distributing", CellState::distributing}}) {
    Simulation s(n, RandomKey(1));
    auto& wet = s.attributes().column<float>("wet").now;
    for (uint32_t i = 0; i < n->size(); ++i) wet[i] = static_cast<float>(i % 5) / 4;
    auto& color = s.attributes().column<Vec3f>("Cd").now;
    for (uint32_t i = 0; i < n->size(); ++i)
      color[i] = wet[i] > 0.4f && wet[i] < 0.8f ? Vec3f(1, 0.5f, 0.25f) : Vec3f(0);
    s.run({stage("freeze",
                 {{"attribute", "wet"}, {"above", 0.5}, {"below", 0.75}, {"as", Value::Name{as}}}),
           stage("spreading_color")},
          3);
    for (uint32_t i = 0; i < n->size(); ++i) {
      const bool frozen = i % 5 == 2 || i % 5 == 3;
      ASSERT_EQ(s.states()[i], frozen ? expected : CellState::active) << i;
      const Vec3f got = s.attributes().values<Vec3f>("Cd")[i];
      if (frozen) {
        ASSERT_EQ(got, Vec3f(1, 0.5f, 0.25f));
      } else {
        ASSERT_EQ(got != Vec3f(0), expected == CellState::distributing) << i;
      }
    }
  }
}

}  // namespace
}  // namespace vug::cells
