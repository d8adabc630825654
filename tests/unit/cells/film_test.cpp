// SPDX-License-Identifier: Apache-2.0
// Films of water: their thickness, their way over networks, and pools.
#include "slopes.h"

#include <vug/base/error.h>
#include <vug/cells/drainage.h>
#include <vug/cells/fill_pools.h>
#include <vug/cells/film.h>
#include <vug/cells/outlets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::cells {
namespace {

std::vector<Vec3f> surface_of(const Simulation& s) {
  std::vector<Vec3f> out = s.network().position;
  const auto& height = s.attributes().values<float>("height");
  for (size_t i = 0; i < out.size(); ++i) out[i] += s.network().normal[i] * height[i];
  return out;
}

/// A slope with hollows, and its outlets.
struct RoughSlope {
  Simulation simulation;
  std::vector<Vec3f> position;
  std::vector<uint8_t> outlet;

  explicit RoughSlope(double angle, uint64_t seed = 3)
      : simulation(slope_network(0.6, 0.3, 0.01, angle), RandomKey(1)) {
    roughen(simulation, 0.08, 0.01, seed);
    position = surface_of(simulation);
    outlet = find_outlets(simulation.network(), simulation.states().data());
  }
  const Network& network() const { return simulation.network(); }
};

TEST(FilmLaw, CubeRootsAreExact) {
  for (double x = 1e-40; x < 1e40; x *= 1.7)
    ASSERT_NEAR(cube_root(x) / std::cbrt(x), 1, 1e-11) << x;
  EXPECT_EQ(cube_root(0), 0);
}

TEST(FilmLaw, ViscosityAgreesWithTables) {
  EXPECT_NEAR(kinematic_viscosity(10) / 1.307e-6, 1, 0.012);
  EXPECT_NEAR(kinematic_viscosity(20) / 1.004e-6, 1, 0.012);
  EXPECT_NEAR(kinematic_viscosity(40) / 0.658e-6, 1, 0.012);
}

TEST(FilmLaw, ThicknessTimesSpeedIsTheFlow) {
  // 1 litre per hour and metre of width at 10 degrees down a wall: 48 micrometres.
  const double q = 1e-3 / 3600, h = film_thickness(q, 1, 1.307e-6);
  EXPECT_NEAR(h, std::cbrt(3 * 1.307e-6 * q / 9.81), 1e-12);
  EXPECT_NEAR(h, 48.1e-6, 0.1e-6);
  EXPECT_NEAR(h * film_speed(q, 1, 1.307e-6), q, 1e-15);
}

TEST(Film, EqualsTheRowsAboveOnASlope) {
  const double c = 0.02, angle = 0.4, rate = 0.3;
  const uint32_t across = 5, rows = 30;
  const auto n = std::make_shared<const Network>(slope_grid(across, rows, c, angle));
  const Simulation s = ran(n, {stage("film", {{"rate", rate}, {"temperature", 15}})}, 1);
  const auto& discharge = s.attributes().values<float>("discharge");
  const auto& film = s.attributes().values<float>("film");
  for (uint32_t i = 0; i < n->size(); ++i) {
    const double expected = (1 + i / across) * c * c * rate / 86400;
    ASSERT_NEAR(static_cast<double>(discharge[i]) / expected, 1, 1e-5) << i;
    if (i + across >= n->size()) continue;  // The last row falls off the edge.
    const double thickness =
        std::cbrt(3 * kinematic_viscosity(15) * expected / c / (9.81 * std::sin(angle)));
    ASSERT_NEAR(static_cast<double>(film[i]) / thickness, 1, 1e-4) << i;
  }
  EXPECT_EQ(total(s, "outlet"), across);
  EXPECT_EQ(total(s, "pool"), 0);
}

TEST(Film, LeavesAtTheLowerEdgeOnly) {
  const RoughSlope slope(0.3);
  const Network& n = slope.network();
  for (uint32_t i = 0; i < n.size(); ++i)
    if (slope.outlet[i]) {
      ASSERT_GT(n.position[i].x, 0.6 * std::cos(0.3) - 0.02) << i;
    }
  EXPECT_GT(std::count(slope.outlet.begin(), slope.outlet.end(), 1), 20);
}

TEST(Film, DripsOffTheLowestPointOfABall) {
  const Surface ball({shared(mesh::sphere_mesh(Vec3d(0), 1, 4))});
  const Network n = build(ball, options("random", 0.1)).network;
  const std::vector<CellState> states(n.size(), CellState::active);
  const std::vector<uint8_t> outlet = find_outlets(n, states.data());
  ASSERT_GE(std::count(outlet.begin(), outlet.end(), 1), 1);
  for (uint32_t i = 0; i < n.size(); ++i)
    if (outlet[i]) {
      EXPECT_LT(n.position[i].y, -0.98f);
    }
}

TEST(Film, AClosedBasinSeepsAwayAtItsLowestCell) {
  mesh::Mesh cave = mesh::sphere_mesh(Vec3d(0), 1, 4);
  for (mesh::Triangle& t : cave.triangles) std::swap(t[0], t[1]);
  for (Vec3f& normal : cave.normals) normal = -normal;
  const Network n = build(Surface({shared(cave)}), options("random", 0.1)).network;
  const std::vector<CellState> states(n.size(), CellState::active);
  const std::vector<uint8_t> outlet = find_outlets(n, states.data());
  ASSERT_EQ(std::count(outlet.begin(), outlet.end(), 1), 1);
  const auto at = std::find(outlet.begin(), outlet.end(), 1) - outlet.begin();
  for (const Vec3f& p : n.position) EXPECT_GE(p.y, n.position[static_cast<size_t>(at)].y);
}

/// The lowest pass to an outlet from every cell, by repeated relaxation of all links.
std::vector<float> slow_levels(const Links& links, const std::vector<float>& height,
                               const std::vector<uint8_t>& outlet) {
  std::vector<float> level(height.size(), 1e9f);
  for (bool changed = true; std::exchange(changed, false);)
    for (uint32_t i = 0; i < height.size(); ++i) {
      float best = outlet[i] ? height[i] : 1e9f;
      for (const uint32_t j : links.of(i)) best = std::min(best, std::max(height[i], level[j]));
      if (best < level[i]) level[i] = best, changed = true;
    }
  return level;
}

TEST(FillPools, EqualsTheLowestPassToAnOutlet) {
  for (const uint64_t seed : {1U, 2U, 3U}) {
    const RoughSlope slope(0.1, seed);
    std::vector<float> height;
    for (const Vec3f& p : slope.position) height.push_back(p.y);
    const Links& links = slope.network().links;
    const std::vector<float> level = fill_pools(links, height, slope.outlet);
    EXPECT_EQ(level, slow_levels(links, height, slope.outlet)) << seed;
    EXPECT_NE(level, height) << seed;
  }
}

TEST(Drainage, LosesNoWater) {
  for (const double head : {0.0, 1e-3, 5e-3}) {
    const RoughSlope slope(0.15);
    const Drainage drainage(slope.network().links, slope.position, slope.outlet, {4, head});
    ASSERT_GT(drainage.pools(), 3u);
    std::vector<Load> load(slope.network().size(), {1, 0.5});
    const auto pass_on = [](uint32_t, const Load& all) { return all; };
    const Load out = drainage.route(load, pass_on, pass_on);
    const auto cells = static_cast<double>(load.size());
    EXPECT_NEAR(out.water / cells, 1, 1e-12) << head;
    EXPECT_NEAR(out.calcium / cells, 0.5, 1e-12) << head;
    for (const Load& each : load) ASSERT_GE(each.water, 1) << head;
  }
}

TEST(Drainage, PoolsAreLevelUpToTheirLowestCrest) {
  const RoughSlope slope(0.1);
  const Drainage drainage(slope.network().links, slope.position, slope.outlet, {4, 1e-3});
  uint32_t deep = 0;
  for (uint32_t p = 0; p < drainage.pools(); ++p) {
    const uint32_t first = drainage.members(p)[0];
    const float level = slope.position[first].y + drainage.depth(first);
    float crest = 1e9f;
    for (const uint32_t i : drainage.members(p)) {
      ASSERT_NEAR(slope.position[i].y + drainage.depth(i), level, 1e-6f);
      ASSERT_GE(drainage.depth(i), 0);
      deep += drainage.depth(i) > 2e-3f;
      for (const uint32_t j : slope.network().links.of(i))
        if (drainage.pool(j) != p) crest = std::min(crest, slope.position[j].y);
    }
    ASSERT_NEAR(crest, level, 1e-6f);
  }
  EXPECT_GT(deep, 50u);
}

TEST(Film, NeedsWater) {
  Simulation s(slope_network(0.3, 0.2, 0.02, 0.3), RandomKey(1));
  s.attributes().column<float>("source");
  const auto message = [&](const NamedValues& parameters) -> std::string {
    try {
      s.run({stage("film", parameters)}, 1);
    } catch (const Error& error) {
      return error.code() == ErrorCode::bad_input ? error.what() : "";
    }
    return "";
  };
  EXPECT_NE(message({}).find("no water enters"), std::string::npos);
  EXPECT_NE(message({{"rate", 0}}).find("no water"), std::string::npos);
  EXPECT_NE(message({{"rate", -1}}), "");
  EXPECT_EQ(message({{"condensation", 0.001}}), "");
}

TEST(Film, LeavesAtGivenOutlets) {
  Simulation s(slope_network(0.3, 0.2, 0.02, 0.3), RandomKey(1));
  auto& outlet = s.attributes().column<float>("outlet").now;
  EXPECT_THROW(s.run({stage("film")}, 1), Error);
  outlet[7] = 1;
  s.run({stage("film", {{"rate", 1}})}, 1);
  const auto& area = s.network().area;
  const double supply = std::accumulate(area.begin(), area.end(), 0.0) / 86400;
  const auto& discharge = s.attributes().values<float>("discharge");
  EXPECT_NEAR(static_cast<double>(discharge[7]) / supply, 1, 1e-4);
}

}  // namespace
}  // namespace vug::cells
