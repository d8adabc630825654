// SPDX-License-Identifier: Apache-2.0
// Forms of walls and ceilings that follow joints, beds, levels and the flow: measured sizes.
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/noise.h>
#include <vug/field/registry.h>
#include <vug/field/speleogens/cross_beds.h>

#include "rocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

namespace vug::field {
namespace {

Field wall_along_x() { return make("half_space", {{"normal", Vec3d(1, 0, 0)}}); }

/// A room of 6 m x 2 m x 6 m whose floor is at 0.
Field flat_room() { return complement(make("box", {{"size", Vec3d(6, 4, 6)}})); }

TEST(Boxwork, HasVeinsOfTheStatedSizeOnItsJoints) {
  const double spacing = 0.1, thickness = 0.006, height = 0.05;
  const Field rock = wall_along_x();
  const Field veins = make("boxwork", {{"field", as_value(rock)},
                                       {"normals", List{Value(Vec3d(0, 0, 1))}},
                                       {"spacing", spacing},
                                       {"thickness", thickness},
                                       {"height", height},
                                       {"ragged", 0.0},
                                       {"wander", 0.0}});
  // Along a line above the rock, across one set of joints.
  const double length = 40, step = 2e-4;
  int count = 0, inside = 0;
  bool before = false;
  for (int i = 0; i < static_cast<int>(length / step); ++i) {
    const bool here = veins.value({0.5 * height, 3, i * step}) < 0;
    EXPECT_EQ(here, veins.value({0.9 * height, -7, i * step}) < 0);  // Planes.
    count += here && !before;
    inside += here;
    before = here;
  }
  EXPECT_NEAR(length / count, spacing, 0.05 * spacing);
  EXPECT_NEAR(inside * step / count, thickness, 0.04 * thickness);
  for (int i = 0; i < 4000; ++i) {
    EXPECT_GT(veins.value({height + 1e-6, 0.01 * i, 0.003 * i}), 0);
    EXPECT_LT(veins.value({-1e-6, 0.01 * i, 0.003 * i}), 0);
  }
}

TEST(Boxwork, EnclosesBoxesOnThreeSets) {
  const Field veins = make("boxwork", {{"field", as_value(wall_along_x())}, {"spacing", 0.08}});
  RandomStream random(RandomKey(4));
  int solid = 0, closed = 0, air = 0;
  for (int i = 0; i < 4000; ++i) {
    const double y = random.uniform(-3, 3), z = random.uniform(-3, 3);
    if (veins.value({0.015, y, z}) < 0) {
      ++solid;
      continue;
    }
    ++air;
    // A box is closed if all eight directions meet a vein within four spacings.
    bool all = true;
    for (int k = 0; k < 8; ++k) {
      bool met = false;
      for (double s = 0; s < 0.32 && !met; s += 0.002)
        met = veins.value({0.015, y + s * std::cos(0.785 * k), z + s * std::sin(0.785 * k)}) < 0;
      all &= met;
    }
    closed += all;
  }
  EXPECT_GT(closed, 0.9 * air);
  EXPECT_LT(solid, 0.25 * (solid + air));
}

TEST(CrossBedding, DipsDownTheFlowAtTheAngleOfRepose) {
  const CrossBedForm form{0.6,           0.04, {1, 0, 0}, {0, 1, 0}, 34 * kPi / 180, 20 * kPi / 180,
                          25 * kPi / 180};
  const CrossBeds beds(form, 77);
  RandomStream random(RandomKey(6));
  std::map<double, double> dips;  // By set: the steepest dip in it.
  for (int i = 0; i < 20000; ++i) {
    const double x = random.uniform(-4, 4), y = random.uniform(-20, 20);
    const Point<Dual<double>> p = seeded(Point<double>{x, y, random.uniform(-4, 4)});
    const CrossBed<Dual<double>> bed = beds.at(p);
    const Vec3d normal(bed.lamina.below.dx, bed.lamina.below.dy, bed.lamina.below.dz);
    EXPECT_LE(normal.length(), beds.lamina_slope() * (1 + 1e-9));
    EXPECT_GT(normal.x, 0);  // Down the flow.
    const double dip = std::atan2(std::hypot(normal.x, normal.z), normal.y) * 180 / kPi;
    const double azimuth = std::atan2(normal.z, normal.x) * 180 / kPi;
    EXPECT_LE(std::fabs(azimuth), 25.01);
    EXPECT_LE(dip, 34.01);
    double& steepest = dips[bed.set_random.v];
    steepest = std::max(steepest, dip);
  }
  for (const double end : {-20.0, 20.0})  // Of these sets, only a part was sampled.
    dips.erase(beds.at(Point<double>{0, end, 0}).set_random);
  EXPECT_GT(dips.size(), 50u);
  double least = 90, most = 0;
  for (const auto& [set, dip] : dips) {
    least = std::min(least, dip);
    most = std::max(most, dip);
  }
  EXPECT_GT(least, 19);
  EXPECT_LT(least, 23);
  EXPECT_GT(most, 32.5);
}

TEST(CrossBedding, FlattensTowardsTheBaseOfASetAndIsCutOffAbove) {
  const CrossBedForm form{1, 0.05, {1, 0, 0}, {0, 1, 0}, 30 * kPi / 180, 30 * kPi / 180, 0};
  const CrossBeds beds(form, 5);
  double previous_set = -1, previous_dip = 0;
  int bases = 0;
  for (int i = 0; i < 40000; ++i) {
    const CrossBed<Dual<double>> bed = beds.at(seeded(Point<double>{0.3, 1e-3 * i, 0.2}));
    const double dip = std::atan2(bed.lamina.below.dx, bed.lamina.below.dy) * 180 / kPi;
    if (bed.set_random.v != previous_set) {
      if (i > 0) {
        EXPECT_NEAR(previous_dip, 30, 0.5);  // Steepest where the next set cuts it off.
        EXPECT_NEAR(std::tan(dip * kPi / 180), std::tan(30 * kPi / 180) / 4, 0.01);
        ++bases;
      }
      previous_set = bed.set_random.v;
    } else {
      EXPECT_GE(dip, previous_dip - 1e-9);
    }
    previous_dip = dip;
  }
  EXPECT_NEAR(bases, 40, 4);
}

// The size of a cell has the factor 1 - H: rock of hardness 0.5 has cells of half the depth, rock
// of hardness 1 none, at the same places.
TEST(Tafoni, AreSmallerInHardRock) {
  const auto deepest = [](const Field& rock) {
    const Field cells = make("tafoni", {{"field", as_value(rock)},
                                        {"from", Vec3d(-0.2, -0.5, -0.5)},
                                        {"to", Vec3d(0.2, 0.5, 0.5)},
                                        {"width", 0.09},
                                        {"spacing", 0.085}});
    double most = 0;
    for (double y = -0.5; y < 0.5; y += 0.01)
      for (double z = -0.5; z < 0.5; z += 0.01) {
        double x = 1e-4;
        while (x > -0.15 && cells.value({x, y, z}) > 0) x -= 0.001;
        most = std::max(most, -x);
      }
    return most;
  };
  const double bare = deepest(wall_along_x());
  EXPECT_EQ(deepest(of(wall_along_x(), "marl", 0)), bare);
  EXPECT_NEAR(deepest(of(wall_along_x(), "marl", 0.5)), 0.5 * bare, 0.004);
  EXPECT_LT(deepest(of(wall_along_x(), "chert", 1)), 0.001) << "less than one step of the search";
}

TEST(Tafoni, AreCellsOfTheStatedWidthWithSharpWalls) {
  const double width = 0.09, spacing = 0.085;
  const Field rock = wall_along_x();
  const Field cells = make("tafoni", {{"field", as_value(rock)},
                                      {"from", Vec3d(-0.2, -1.2, -1.2)},
                                      {"to", Vec3d(0.2, 1.2, 1.2)},
                                      {"width", width},
                                      {"spacing", spacing},
                                      {"depth", 0.6}});
  // Depth of the wall on a grid; cells are its minima.
  const int n = 200;
  const double step = 0.01;
  std::vector<double> depth;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      double x = 1e-4;
      while (x > -0.15 && cells.value({x, -1 + step * i, -1 + step * k}) > 0) x -= 0.002;
      depth.push_back(-x);
    }
  double mean = 0;
  int whole = 0;
  for (const double d : depth) {
    mean += d / n / n;
    whole += d < 0.002;
  }
  EXPECT_GT(*std::max_element(depth.begin(), depth.end()), 0.6 * width);
  EXPECT_LT(*std::max_element(depth.begin(), depth.end()), 0.6 * width * 1.6);
  EXPECT_GT(mean, 0.2 * width);
  EXPECT_LT(whole, 0.35 * n * n);  // Little of the face is left.
  EXPECT_GT(whole, 0.01 * n * n);
  // The walls between cells are cusps: the slope turns by over 60 degrees within 4 mm.
  int cusps = 0;
  for (int line = 0; line < 60; ++line) {
    const double y = -0.9 + 0.03 * line;
    std::vector<double> fine;
    for (int k = 0; k < 400; ++k) {
      double x = 1e-4;
      while (x > -0.15 && cells.value({x, y, -0.8 + 0.004 * k}) > 0) x -= 5e-4;
      fine.push_back(-x);
    }
    for (size_t k = 1; k + 1 < fine.size(); ++k)
      cusps += fine[k] < fine[k - 1] && fine[k] < fine[k + 1] && fine[k] > 0.001 &&
               fine[k - 1] + fine[k + 1] - 2 * fine[k] > 1.15 * 0.004;
  }
  EXPECT_GT(cusps, 100);
}

TEST(CeilingHalfTube, FollowsTheCeilingAtItsWidthAndHeight) {
  const Field rock = flat_room();
  const auto tube = [&](double height, double wavelength) {
    return make("ceiling_half_tube", {{"field", as_value(rock)},
                                      {"path", List{Value(Vec3d(-2, 0, 0)), Value(Vec3d(2, 0, 0))}},
                                      {"width", 0.4},
                                      {"height", height},
                                      {"wavelength", wavelength},
                                      {"swing", 0.3}});
  };
  for (const double height : {0.15, 0.2, 0.5}) {
    const Field straight = tube(height, 0);
    for (double x = -1.5; x < 1.5; x += 0.05) {
      EXPECT_GT(straight.value({x, 2 + height - 1e-3, 0}), 0);
      EXPECT_LT(straight.value({x, 2 + height + 1e-3, 0}), 0);
      if (height < 0.2) continue;
      EXPECT_GT(straight.value({x, 2 + 1e-3, 0.19}), 0);
      EXPECT_LT(straight.value({x, 2 + 1e-3, 0.201}), 0);
    }
    EXPECT_LT(straight.value({0, -2.001, 0}), 0);  // The floor stays.
  }
  // It swings to both sides.
  const Field winding = tube(0.2, 1.5);
  double left = 0, right = 0;
  for (double x = -1.8; x < 1.8; x += 0.02)
    for (double z = -0.5; z < 0.5; z += 0.02)
      if (winding.value({x, 2.15, z}) > 0) {
        left = std::min(left, z);
        right = std::max(right, z);
      }
  EXPECT_LT(left, -0.3);
  EXPECT_GT(right, 0.3);
}

TEST(MeanderNiche, AlternatesBetweenTheWallsAndMovesDownstream) {
  const Noise niches = make_noise("meander_niche", {{"levels", List{Value(0.0), Value(2.0)}},
                                                    {"height", 0.8},
                                                    {"roof", 0.1},
                                                    {"wavelength", 8.0},
                                                    {"migration", 1.0},
                                                    {"width", 2.0}});
  const auto deepest = [&](double y, double z) {
    double best = 0, where = 0;
    for (int i = 0; i < 800; ++i)
      if (const double v = niches.field.value({0.01 * i, y, z}); v < best) {
        best = v;
        where = 0.01 * i;
      }
    EXPECT_NEAR(best, -1, 1e-3);
    return where;
  };
  const auto apart = [](double a, double b) { return std::fabs(std::remainder(a - b, 8.0)); };
  const double left = deepest(-0.08, -1), right = deepest(-0.08, 1);
  EXPECT_NEAR(apart(left, right), 4, 0.03);  // Half of a meander.
  // A niche 2 m higher lies 2 m upstream.
  EXPECT_NEAR(std::remainder(deepest(-0.08, 1) - deepest(1.92, 1) - 2, 8.0), 0, 0.03);
  EXPECT_EQ(niches.field.value({right, 0.01, 1}), 0);  // A flat roof.
  EXPECT_EQ(niches.field.value({right, -0.08, 0}), 0);
}

TEST(Pendants, HangBetweenChannelsOfTheStatedWidth) {
  const Field rock = flat_room();
  const double width = 0.2, height = 0.4;
  const Field hung = make("pendants", {{"field", as_value(rock)},
                                       {"spacing", 0.5},
                                       {"width", width},
                                       {"height", height},
                                       {"level", 0.0},
                                       {"wander", 0.0}});
  double open = 0, borders = 0;
  const double step = 0.004;
  for (int line = 0; line < 300; ++line) {
    const double z = -2.7 + 0.018 * line;
    bool before = hung.value({-2.8, 2.2, z}) > 0;
    for (int i = 1; i < 1400; ++i) {
      const Vec3d p(-2.8 + step * i, 2.2, z);
      const bool here = hung.value(p) > 0;
      EXPECT_EQ(here, hung.value(p + Vec3d(0, 0.19, 0)) > 0);  // Plumb walls.
      EXPECT_LT(hung.value(p + Vec3d(0, 0.201, 0)), 0);        // The roof of the channels.
      EXPECT_LT(hung.value({p.x, -2.01, p.z}), 0);             // The floor is whole.
      open += here;
      borders += here != before;
      before = here;
    }
  }
  const double chord = open * step / (0.5 * borders);
  EXPECT_GT(chord, 1.2 * width);  // As those of anastomoses: strips in all directions.
  EXPECT_LT(chord, 2.6 * width);
}

TEST(Spongework, HasTheStatedPorosityDownToItsDepth) {
  const Field rock = make("half_space");
  RandomStream random(RandomKey(12));
  for (const double porosity : {0.2, 0.4, 0.6}) {
    const Field sponge =
        make("spongework",
             {{"field", as_value(rock)}, {"size", 0.2}, {"porosity", porosity}, {"depth", 1.5}});
    int air = 0;
    const int count = 40000;
    for (int i = 0; i < count; ++i) {
      const double x = random.uniform(-9, 9), y = random.uniform(-1.3, -0.2);
      const Vec3d p(x, y, random.uniform(-9, 9));
      air += sponge.value(p) > 0;
      EXPECT_LT(sponge.value({p.x, -1.501, p.z}), 0);
    }
    EXPECT_NEAR(static_cast<double>(air) / count, porosity, 0.02);
  }
}

}  // namespace
}  // namespace vug::field
