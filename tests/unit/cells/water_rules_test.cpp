// SPDX-License-Identifier: Apache-2.0
// Effects of water on rock: it runs, seeps in, dries and leaves salt; and dust, which moves
// similarly.
#include "run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace vug::cells {
namespace {

NetworkPtr on(mesh::Mesh mesh, const std::string& grid, double spacing) {
  const Surface surface({shared(std::move(mesh))});
  return std::make_shared<const Network>(build(surface, options(grid, spacing)).network);
}

/// Vertical, 1 m wide and 2 m high.
mesh::Mesh wall_mesh() {
  mesh::Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {1, 2, 0}, {0, 2, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  return mesh;
}

TEST(RunOff, ConservesWaterOrCountsItAsLost) {
  const NetworkPtr n = uneven();
  const double speed = 0.1;
  const Simulation s = ran(n, {stage("run_off", {{"speed", speed}, {"dry", 0.5}})}, 40);
  // A move of the water adds the rain of one spacing to every cell; there are 40 * speed / c moves.
  const double moved = std::floor(40 * speed / n->spacing + 1e-9);
  const double rain = moved * n->spacing * static_cast<double>(n->size());
  EXPECT_NEAR((total(s, "water") + total(s, "lost")) / rain, 1, 1e-5);
  EXPECT_GT(total(s, "lost"), 0.1 * rain);
  EXPECT_GT(total(s, "water"), 0.01 * rain);
}

TEST(RunOff, EqualsTheWallAboveInASteadyFlow) {
  const double c = 0.05;
  const uint32_t across = 6, high = 40;
  Network wall;
  wall.spacing = c, wall.full = 4;
  for (uint32_t i = 0; i < across * high; ++i)
    wall.position.push_back(
        Vec3f(static_cast<float>(c * (i % across)), static_cast<float>(-c * (i / across)), 0));
  wall.normal.assign(wall.position.size(), Vec3f(0, 0, 1));
  wall.links = make_links(wall.size(), [&](uint32_t i, const auto& add) {
    if (i >= across) add(i - across);
    if (i % across > 0) add(i - 1);
    if (i % across + 1 < across) add(i + 1);
    if (i + across < wall.size()) add(i + across);
  });
  const NetworkPtr n = std::make_shared<const Network>(wall);
  const double dry = 0.7, settle = 0.3, speed = 0.1, strength = 0.02;
  const NamedValues parameters = {
      {"dry", dry}, {"settle", settle}, {"speed", speed}, {"strength", strength}, {"wander", 0}};
  Simulation s = ran(n, {stage("run_off", parameters)}, 60);
  const double kept = std::exp(-c / dry), carried = std::exp(-c / settle);
  const std::vector<float> stain = s.attributes().values<float>("stain");
  s.run({stage("run_off", parameters)}, 1);  // Moves the water twice.
  for (uint32_t i = 0; i < n->size(); ++i) {
    const double rows = 1 + i / across;
    const auto sum = [&](double left) { return c * (1 - std::pow(left, rows)) / (1 - left); };
    ASSERT_NEAR(s.attributes().values<float>("water")[i], sum(kept), 1e-4) << rows;
    ASSERT_NEAR(s.attributes().values<float>("load")[i], sum(carried), 1e-4) << rows;
    const double grown = static_cast<double>(s.attributes().values<float>("stain")[i] - stain[i]);
    ASSERT_NEAR(grown, strength / speed * 2 * (1 - carried) * sum(carried), 1e-5) << rows;
  }
}

TEST(RunOff, EntersAtItsSource) {
  const NetworkPtr n = on(wall_mesh(), "triangle", 0.05);
  Simulation s(n, RandomKey(1));
  auto& source = s.attributes().column<float>("source").now;
  for (uint32_t i = 0; i < n->size(); ++i)
    source[i] = std::fabs(n->position[i].y - 1) < 0.03f && n->position[i].x < 0.5f ? 1.0f : 0.0f;
  s.run({stage("run_off", {{"speed", 0.05}})}, 100);
  double wet = 0;
  for (uint32_t i = 0; i < n->size(); ++i) {
    if (n->position[i].y > 1.04f) {
      ASSERT_EQ(s.attributes().values<float>("stain")[i], 0) << i;
    }
    wet += n->position[i].y < 0.5f && s.attributes().values<float>("water")[i] > 0;
  }
  EXPECT_GT(wet, 20);
}

TEST(RunOff, GathersInStreaks) {
  const NetworkPtr n = on(wall_mesh(), "triangle", 0.025);
  const auto largest = [&](double cling) {
    const Simulation s = ran(n, {stage("run_off", {{"cling", cling}, {"dry", 1e6}})}, 80);
    double most = 0;
    for (uint32_t i = 0; i < n->size(); ++i)
      if (n->position[i].y > 0.2f && n->position[i].y < 0.4f)
        most = std::max(most, static_cast<double>(s.attributes().values<float>("water")[i]));
    return most;
  };
  const double spread = largest(0), gathered = largest(1);
  EXPECT_LT(spread, 6);  // With a mean of 1.7.
  EXPECT_GT(gathered, 2 * spread);
}

TEST(Moisture, ConservesMoistureWithoutDrying) {
  const NetworkPtr n = uneven();
  Simulation s = ran(n, {stage("sprinkle", {{"attribute", "moisture"}, {"share", 0.1}})}, 1);
  const double before = total(s, "moisture");
  s.run({stage("moisture", {{"reach", 1e9}, {"creep", 0.2}})}, 100);
  EXPECT_NEAR(total(s, "moisture") / before, 1, 1e-5);
  for (const float m : s.attributes().values<float>("moisture")) {
    ASSERT_GE(m, 0);
    ASSERT_LT(m, 1);
  }
}

/// Cells next to a line that is always wet, in a closed row.
struct WetLine {
  static constexpr uint32_t kAcross = 64;
  Simulation simulation;
  double fall;  ///< Decrease of the logarithm of moisture from cell to cell.

  explicit WetLine(int steps)
      : simulation(torus(kAcross, 4, 4), RandomKey(1)), fall(std::acosh(1 + 0.5 / 9)) {
    auto& water = simulation.attributes().column<float>("water").now;
    for (uint32_t i = 0; i < water.size(); i += kAcross) water[i] = 1;
    // In equilibrium m(x - 1) + m(x + 1) = (2 + (c / reach)^2) m(x).
    simulation.run({stage("moisture", {{"reach", 3}, {"creep", 2}})}, steps);
  }
};

TEST(Moisture, FallsExponentiallyNextToWater) {
  const WetLine line(300);
  for (uint32_t x = 0; x < WetLine::kAcross; ++x)
    ASSERT_NEAR(line.simulation.attributes().values<float>("moisture")[x],
                std::cosh((32.0 - x) * line.fall) / std::cosh(32 * line.fall), 1e-5)
        << x;
}

TEST(Efflorescence, ConservesSalt) {
  const NetworkPtr n = uneven();
  Simulation s =
      ran(n, {stage("sprinkle", {{"attribute", "moisture"}, {"share", 0.02}, {"radius", 0.3}})}, 1);
  const double before = total(s, "moisture");
  s.run({stage("moisture", {{"reach", 0.2}, {"creep", 0.1}}),
         stage("efflorescence", {{"creep", 0.1}})},
        1);
  const double brine = total(s, "brine") + total(s, "salt");
  EXPECT_GT(brine, 0.5 * before);
  s.run({stage("moisture", {{"reach", 0.2}, {"creep", 0.1}}),
         stage("efflorescence", {{"creep", 0.1}})},
        200);
  EXPECT_NEAR((total(s, "brine") + total(s, "salt")) / brine, 1, 1e-4);
  EXPECT_GT(total(s, "salt"), 0.9 * brine);  // Nearly all is dry.
}

TEST(Efflorescence, BeginsWhereBrineIsSaturated) {
  WetLine line(300);
  line.simulation.run({stage("efflorescence", {{"solubility", 3}, {"creep", 2}})}, 300);
  const auto& salt = line.simulation.attributes().values<float>("salt");
  // The flow past each cell is the same, so brine is 1 / m times as strong as at the line.
  const auto first = static_cast<uint32_t>(std::ceil(std::log(3.0) / line.fall));
  for (uint32_t x = 0; x < first; ++x) ASSERT_EQ(salt[x], 0) << x;
  EXPECT_GT(salt[first], 0.1);
  for (uint32_t x = first + 1; x < 20; ++x) ASSERT_LT(salt[x + 1], salt[x]) << x;
}

TEST(Dust, IsConservedAndRestsBelowItsSlopeOfRepose) {
  mesh::Mesh mesh;  // A floor, and next to it a slope of 45 degrees.
  mesh.positions = {{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}, {2, 1, 1}, {2, 1, 0}};
  mesh.triangles = {{0, 1, 2}, {0, 2, 3}, {3, 2, 4}, {3, 4, 5}};
  const NetworkPtr n = on(mesh, "triangle", 0.05);
  Simulation s(n, RandomKey(1));
  const double fall = 1e-4;
  s.run({stage("dust", {{"fall", fall}})}, 50);
  double settled = 0;
  for (const Vec3f& normal : n->normal)
    settled += 50 * fall * std::max(0.0, static_cast<double>(normal.y));
  EXPECT_NEAR((total(s, "dust") + total(s, "fallen")) / settled, 1, 1e-4);
  s.run({stage("dust", {{"fall", 0}})}, 200);
  EXPECT_NEAR((total(s, "dust") + total(s, "fallen")) / settled, 1, 1e-4);
  const auto& dust = s.attributes().values<float>("dust");
  double foot = 0;
  for (uint32_t i = 0; i < n->size(); ++i) {
    ASSERT_NEAR(s.attributes().values<float>("height")[i], dust[i], 1e-7);
    const float x = n->position[i].x;
    if (x < 0.3f) {
      ASSERT_NEAR(dust[i], 50 * fall, 1e-6);
    }
    if (x > 1.5f) {
      ASSERT_LT(dust[i], 1e-6f);
    }
    if (dust[i] < 1e-6f) continue;
    for (const uint32_t to : n->links.of(i)) {
      const Vec3f way = n->position[to] - n->position[i];
      const float drop = dust[i] * n->normal[i].y - dust[to] * n->normal[to].y - way.y;
      ASSERT_LT(drop, std::tan(35 * kPi / 180) * std::hypot(way.x, way.z) + 1e-3);
    }
    foot = std::max(foot, x < 1.05f ? static_cast<double>(dust[i]) : 0);
  }
  EXPECT_GT(foot, 4 * 50 * fall);  // Dust that slid down rests there.
}

TEST(Dust, FallsFromOverhangsAndAvoidsOpenPlaces) {
  const NetworkPtr n = on(mesh::sphere_mesh(Vec3d(0), 0.5, 4), "random", 0.05);
  Simulation s(n, RandomKey(1));
  auto& open = s.attributes().column<float>("exposure").now;
  for (uint32_t i = 0; i < n->size(); ++i) open[i] = n->position[i].x > 0 ? 1.0f : 0.0f;
  s.run({stage("dust", {{"shelter", 1}, {"speed", 0.2}})}, 100);
  EXPECT_GT(total(s, "fallen"), 0.1 * total(s, "dust"));
  for (uint32_t i = 0; i < n->size(); ++i) {
    const Vec3f& normal = n->normal[i];
    const float dust = s.attributes().values<float>("dust")[i];
    if (normal.y <= 0) {
      ASSERT_EQ(dust, 0);
    }
    if (normal.x > 0.3f) {
      ASSERT_LT(dust, 5e-5f);
    }
  }
}

}  // namespace
}  // namespace vug::cells
