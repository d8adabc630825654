// SPDX-License-Identifier: Apache-2.0
// Needles, petals, plates, and forms of ice and lava: their sizes and directions.
#include "scatter_fixture.h"

#include <vug/field/boolean.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/hex_plate.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::field {
namespace {

TEST(Frostwork, StandsInBushesOfNeedles) {
  const Field wall = make("half_space");
  const double length = 0.02, diameter = 0.001;
  const Field bushes = make("frostwork", {{"field", as_value(wall)},
                                          {"from", Vec3d(-0.2, -0.05, -0.2)},
                                          {"to", Vec3d(0.2, 0.05, 0.2)},
                                          {"spacing", 0.08},
                                          {"length", length},
                                          {"diameter", diameter},
                                          {"needles", 6},
                                          {"branches", 0}});
  SurfaceScatter scatter = scatter_on(wall, 0.2, 0.08);
  scatter.from.y = -0.05;
  scatter.to.y = 0.05;
  const auto places = find_surface_places(scatter);
  ASSERT_GT(places.size(), 15u);
  for (const SurfacePlace& place : places) {
    // On half a sphere about the foot, needles are small dots near their length.
    const auto needles_at = [&](double away) {
      int inside = 0;
      for (int i = 0; i < 20000; ++i) {
        const double up = (i + 0.5) / 20000, turn = 2.399963 * i, side = std::sqrt(1 - up * up);
        const Vec3d way(side * std::cos(turn), up, side * std::sin(turn));
        const double value = bushes.value(place.at + way * away);
        EXPECT_GT(value, -0.5 * diameter);
        inside += value < 0;
      }
      return inside;
    };
    EXPECT_GT(needles_at(0.3 * length), 0);
    EXPECT_EQ(needles_at(1.7 * length), 0);
    // Straight needles only, so the share of the sphere is at most that of six discs.
    EXPECT_LT(needles_at(0.3 * length) / 20000.0,
              6 * 0.5 * std::pow(0.5 * diameter / (0.3 * length), 2) * 1.2);
  }
}

TEST(GypsumFlower, CurlsByTheStatedAngle) {
  const auto flower = [](double degrees) {
    return make("gypsum_flower", {{"length", 0.1},
                                  {"petals", 1},
                                  {"width", 0.004},
                                  {"thickness", 0.004},
                                  {"curl", Number{degrees * kPi / 180, Dimension::angle}}});
  };
  // A petal that does not curl is straight; one that turns by 250 degrees comes back.
  EXPECT_GT(flower(0).bounds().size().length(), 0.06);
  const Box3d straight = flower(0).bounds(), curled = flower(250).bounds();
  EXPECT_LT(curled.max.y, 0.8 * straight.max.y);
  EXPECT_GT(curled.max.y, 0.2 * straight.max.y);
  // It is as thick as stated: a fibre.
  const Field fibre = flower(0);
  double deepest = 0;
  for (double x = -0.1; x < 0.1; x += 0.002)
    for (double y = -0.01; y < 0.13; y += 0.002)
      for (double z = -0.1; z < 0.1; z += 0.002)
        deepest = std::min(deepest, fibre.value({x, y, z}));
  EXPECT_LT(deepest, -0.0005);
  EXPECT_GE(deepest, -0.002);
}

TEST(HexPlate, HasSixEdgesAndTwoFaces) {
  const HexPlate plate({0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 0.1, 0.01);
  const auto at = [&](const Vec3d& p) { return plate.distance(point(p)); };
  for (int k = 0; k < 6; ++k) {
    const double edge = k * kPi / 3, corner = edge + kPi / 6, radius = 0.1 / std::cos(kPi / 6);
    EXPECT_NEAR(at({0.15 * std::cos(edge), 0, 0.15 * std::sin(edge)}), 0.05, 1e-9);
    EXPECT_NEAR(at({radius * std::cos(corner), 0, radius * std::sin(corner)}), 0, 1e-9);
  }
  EXPECT_NEAR(at({0.01, 0.05, 0.02}), 0.04, 1e-9);
  EXPECT_NEAR(at({0, 0, 0}), -0.01, 1e-9);
}

TEST(Hoar, StandsOnTheSurfaceAndMeetsTheDraught) {
  const Field ball = make("sphere", {{"radius", 0.3}});
  const auto frosted = [&](const Vec3d& wind) {
    return make("hoar", {{"field", as_value(ball)},
                         {"from", Vec3d(-0.4, -0.1, -0.4)},
                         {"to", Vec3d(0.4, 0.1, 0.4)},
                         {"spacing", 0.02},
                         {"diameter", 0.02},
                         {"thickness", 0.001},
                         {"wind", wind}});
  };
  const auto share = [](const Field& field, double x) {
    RandomStream random(RandomKey(7));
    int ice = 0, air = 0;
    while (air < 20000) {
      const double y = random.uniform(-0.08, 0.08), z = random.uniform(-0.08, 0.08);
      const Vec3d p = Vec3d(x, y, z).normalized() * random.uniform(0.302, 0.312);
      ++air;
      ice += field.value(p) < 0;
    }
    return ice / 20000.0;
  };
  const Field still = frosted(Vec3d(0)), blown = frosted(Vec3d(1, 0, 0));
  // Plates of 2 cm x 1 mm, one on 4 cm^2: about a twentieth.
  EXPECT_NEAR(share(still, -0.3), 0.05, 0.03);
  EXPECT_GT(share(blown, -0.3), 3 * share(blown, 0.3));
}

TEST(CaveRafts, FloatAtTheLevelOfTheWater) {
  const Field rafts = make("cave_rafts", {{"radius", 0.3}, {"plate", 0.03}, {"thickness", 0.001}});
  int covered = 0;
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-0.2, 0.2), z = random.uniform(-0.2, 0.2);
    covered += rafts.value({x, 0, z}) < 0;
    EXPECT_NEAR(std::max(rafts.value({x, 0.0005, z}), 0.0), std::max(rafts.value({x, 0, z}), 0.0),
                1e-3);
    EXPECT_GT(rafts.value({x, 0.00051, z}), 0);
    EXPECT_GT(rafts.value({x, -0.00051, z}), 0);
  }
  EXPECT_GT(covered, 2000);
  EXPECT_LT(covered, 12000);
}

TEST(FrozenColumn, HasAWaistAndRipplesOfNineMillimetres) {
  const Field column =
      make("frozen_column", {{"height", 1.8}, {"radius", 0.3}, {"waist", 0.5}, {"relief", 0.002}});
  const auto radius = [&](double y) {
    double low = 0, high = 1;
    for (int i = 0; i < 50; ++i) {
      const double middle = 0.5 * (low + high);
      (column.value({middle, y, 0}) < 0 ? low : high) = middle;
    }
    return low;
  };
  EXPECT_NEAR(radius(1e-6), 0.3, 1e-4);
  EXPECT_NEAR(radius(0.6 * 1.8), 0.15, 0.0021);
  int crests = 0;
  std::vector<double> sizes;
  for (double y = 0.9; y < 1.35; y += 0.0005) sizes.push_back(radius(y));
  for (size_t i = 1; i + 1 < sizes.size(); ++i)
    crests += sizes[i] > sizes[i - 1] && sizes[i] >= sizes[i + 1];
  EXPECT_NEAR(crests, 50, 1);
}

TEST(Lavacicles, HangPlumbFromTheRoof) {
  const Field room = complement(make("box", {{"size", Vec3d(4, 2, 4)}}));
  const Field hung = make("lavacicles", {{"field", as_value(room)},
                                         {"from", Vec3d(-1.5, -1.2, -1.5)},
                                         {"to", Vec3d(1.5, 1.2, 1.5)},
                                         {"spacing", 0.3},
                                         {"length", 0.2}});
  int cones = 0;
  double longest = 0;
  for (int i = 0; i < 300; ++i)
    for (int k = 0; k < 300; ++k) {
      const double x = -1.5 + 0.01 * i, z = -1.5 + 0.01 * k;
      EXPECT_LT(hung.value({x, -1.001, z}), 0);
      EXPECT_GT(hung.value({x, -0.97, z}), 0);  // None on the floor.
      if (hung.value({x, 0.9, z}) > 0) continue;
      // Plumb: everything above a point of a cone is stone, too.
      double y = 0.9;
      while (hung.value({x, y, z}) < 0) y -= 0.005;
      for (double up = y + 0.006; up < 1.05; up += 0.01) EXPECT_LT(hung.value({x, up, z}), 0);
      longest = std::max(longest, 1 - y);
      ++cones;
    }
  EXPECT_GT(cones, 500);
  EXPECT_GT(longest, 0.3);
  EXPECT_LT(longest, 0.2 * 3);
}

TEST(LavaBench, RunsAlongBothWallsAtItsLevel) {
  const Field rock = complement(make("box", {{"size", Vec3d(20, 4, 4)}}));
  const Field bench = make("lava_bench", {{"field", as_value(rock)},
                                          {"levels", List{Value(-0.5)}},
                                          {"width", 0.5},
                                          {"thickness", 0.4},
                                          {"lip", 0.25},
                                          {"wander", 0.0}});
  for (double x = -9; x < 9; x += 0.3)
    for (const double side : {-1.0, 1.0}) {
      EXPECT_LT(bench.value({x, -0.5 - 1e-6, side * 1.51}), 0);
      EXPECT_GT(bench.value({x, -0.5 + 1e-6, side * 1.51}), 0);
      EXPECT_GT(bench.value({x, -0.6, side * 1.49}), 0);
      EXPECT_LT(bench.value({x, -0.74, side * 1.51}), 0);
      EXPECT_GT(bench.value({x, -0.76, side * 1.501}), 0);
      EXPECT_LT(bench.value({x, -0.89, side * 1.99}), 0);
      EXPECT_GT(bench.value({x, -0.91, side * 1.99}), 0);
    }
}

}  // namespace
}  // namespace vug::field
