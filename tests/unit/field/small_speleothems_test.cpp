// SPDX-License-Identifier: Apache-2.0
// Small speleothems: their numbers, angles and levels.
#include "scatter_fixture.h"

#include <vug/field/boolean.h>
#include <vug/field/material_source.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/dome_curve.h>
#include <vug/field/speleothems/pearls.h>
#include <vug/field/speleothems/random_curve.h>
#include <vug/field/speleothems/scalenohedron.h>

#include "rocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace vug::field {
namespace {

constexpr double kDegree = kPi / 180;

// Dana's angles between the faces of {21-31} of calcite.
TEST(Scalenohedron, HasTheAnglesOfCalcite) {
  const Scalenohedron crystal({0, 0, 0}, {0, 1, 0}, 1, 0.3);
  const auto& n = crystal.normals();
  const auto angle = [](const Vec3d& a, const Vec3d& b) { return std::acos(a.dot(b)) / kDegree; };
  EXPECT_NEAR(angle(n[0], n[1]), 35 + 36.0 / 60, 0.02);
  EXPECT_NEAR(angle(n[0], n[3]), 75 + 22.0 / 60, 0.02);
  double lateral = 180;
  for (const Vec3d& low : n) lateral = std::min(lateral, angle(n[0], -low));
  EXPECT_NEAR(lateral, 47 + 1.5 / 60, 0.02);
  for (const Vec3d& each : n) EXPECT_NEAR(angle(each, {0, 1, 0}), 69 + 2.0 / 60, 0.02);
  // Both tips lie on the surface.
  EXPECT_NEAR(crystal.distance(Point<double>{0, 1, 0}), 0, 1e-12);
  EXPECT_NEAR(crystal.distance(Point<double>{0, -1, 0}), 0, 1e-12);
  EXPECT_LT(crystal.distance(Point<double>{0, 0.99, 0}), 0);
}

TEST(DogtoothSpar, StandsOnTheWallWithinItsTilt) {
  const Field wall = make("half_space", {{"normal", Vec3d(1, 0, 0)}});
  const Field spar = make("dogtooth_spar", {{"field", as_value(wall)},
                                            {"from", Vec3d(-0.1, -0.2, -0.2)},
                                            {"to", Vec3d(0.1, 0.2, 0.2)},
                                            {"spacing", 0.08},
                                            {"length", 0.03},
                                            {"tilt", Number{20 * kDegree, Dimension::angle}}});
  // The tip of each crystal is the place farthest from the wall near it.
  const auto places = find_surface_places([&] {
    SurfaceScatter s = scatter_on(wall, 0.2, 0.08);
    s.from.x = -0.1;
    s.to.x = 0.1;
    return s;
  }());
  ASSERT_GT(places.size(), 15u);
  double steepest = 0;
  for (const SurfacePlace& place : places) {
    double height = 0, aside = 0;
    for (double x = 0.066; x > 0.005 && height == 0; x -= 2e-4)
      for (double y = -0.028; y <= 0.028; y += 1e-3)
        for (double z = -0.028; z <= 0.028; z += 1e-3)
          if (spar.value(place.at + Vec3d(x, y, z)) < 0) {
            height = x;
            aside = std::hypot(y, z);
          }
    ASSERT_GT(height, 0.03 * 0.4 * std::cos(20 * kDegree));
    EXPECT_LT(height, 0.066);
    const double angle = std::atan2(aside, height) / kDegree;
    EXPECT_LE(angle, 20 + 3) << place.at;  // The grid of the search has 1 mm.
    steepest = std::max(steepest, angle);
  }
  EXPECT_GT(steepest, 12);  // They are not all upright.
}

/// Diameters of single knobs on long stalks: twice the depth of the deepest point near each place.
std::vector<double> knob_diameters(const Field& rock, const Vec3d& wind) {
  const Field grown = make("popcorn", {{"field", as_value(rock)},
                                       {"from", Vec3d(-0.3)},
                                       {"to", Vec3d(0.3)},
                                       {"spacing", 0.08},
                                       {"diameter", 0.012},
                                       {"stalk", 0.02},
                                       {"cluster", 1},
                                       {"wind", wind}});
  std::vector<double> out;
  for (const SurfacePlace& place : find_surface_places(scatter_on(rock, 0.3, 0.08))) {
    const auto [u, v] = tangents(place.normal);
    double deepest = 0;
    for (double x = -0.026; x < 0.026; x += 0.0013)
      for (double y = -0.026; y < 0.026; y += 0.0013)
        for (double z = 0.012; z < 0.07; z += 0.0013)
          deepest = std::min(deepest, grown.value(place.at + u * x + v * y + place.normal * z));
    out.push_back(-2 * deepest);
  }
  return out;
}
double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

TEST(Popcorn, HasKnobsOfTheStatedSize) {
  const std::vector<double> knobs = knob_diameters(make("half_space"), Vec3d(0));
  EXPECT_GT(knobs.size(), 30u);
  for (const double knob : knobs) {
    EXPECT_GT(knob, 0.0055);  // The search has 1.3 mm steps.
    EXPECT_LT(knob, 0.0205);
  }
  EXPECT_NEAR(mean_of(knobs), 0.012, 0.0015);
}

TEST(Popcorn, GrowsOnProjectionsAndOnTheWindwardSide) {
  const double flat = mean_of(knob_diameters(make("half_space"), Vec3d(0)));
  // Pegs and pits of 5 cm.
  const auto repeated = [](const Field& solid) {
    return make("repeat", {{"field", as_value(solid)}, {"spacing", Vec3d(0.2, 0, 0.2)}});
  };
  const Field ball = make("sphere", {{"radius", 0.025}});
  const double on_balls = mean_of(knob_diameters(repeated(ball), Vec3d(0)));
  const double in_hollow =
      mean_of(knob_diameters(complement(make("sphere", {{"radius", 0.08}})), Vec3d(0)));
  EXPECT_GT(on_balls, 1.1 * flat);
  EXPECT_LT(in_hollow, 0.95 * flat);
  // In a draught against the plane, along it, and away from it.
  EXPECT_GT(mean_of(knob_diameters(make("half_space"), Vec3d(0, -1, 0))), 1.2 * flat);
  EXPECT_NEAR(mean_of(knob_diameters(make("half_space"), Vec3d(1, 0, 0))), 0.7 * flat, 0.15 * flat);
  EXPECT_EQ(mean_of(knob_diameters(make("half_space"), Vec3d(0, 1, 0))), 0);
}

TEST(Popcorn, EndsAtASharpLine) {
  const Field wall = make("half_space", {{"normal", Vec3d(1, 0, 0)}});
  const Field grown = make("popcorn", {{"field", as_value(wall)},
                                       {"from", Vec3d(-0.1, -1, -0.3)},
                                       {"to", Vec3d(0.1, 0.2, 0.3)},
                                       {"diameter", 0.012},
                                       {"stalk", 0.0}});
  const double reach = 1.7 * 0.012 * 1.7;
  int below = 0;
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 20000; ++i) {
    const double z = random.uniform(-0.3, 0.3), x = random.uniform(1e-3, 0.01);
    EXPECT_GT(grown.value({x, 0.2 + reach + 0.1 * random.uniform(), z}), 0);
    below += grown.value({x, 0.2 - 0.04 * random.uniform(), z}) < 0;
  }
  EXPECT_GT(below, 5000);
}

TEST(CaveClouds, EndAtTheLevelOfTheWater) {
  const double level = 0.123;
  const Field wall = make("half_space", {{"normal", Vec3d(1, 0, 0)}});
  const Field clouds = make("cave_clouds", {{"field", as_value(wall)},
                                            {"from", Vec3d(-0.2, -0.5, -0.5)},
                                            {"to", Vec3d(0.2, 0.5, 0.5)},
                                            {"level", level},
                                            {"diameter", 0.15},
                                            {"spacing", 0.08}});
  int wet = 0;
  double highest = -1;
  for (int i = 0; i < 1000; ++i) {
    const double z = -0.4 + 0.0008 * i;
    for (const double x : {0.005, 0.02, 0.04}) {
      EXPECT_GT(clouds.value({x, level + 1e-6, z}), 0);
      if (clouds.value({x, level - 1e-6, z}) < 0) highest = level;
    }
    wet += clouds.value({0.01, level - 0.2, z}) < 0;
  }
  EXPECT_EQ(highest, level);
  EXPECT_GT(wet, 900);  // A coating without gaps.
}

TEST(Shelfstone, HasItsTopExactlyAtTheLevelAndTheStatedWidth) {
  const Field wall = make("half_space", {{"normal", Vec3d(1, 0, 0)}});
  const auto shelf_of = [&](double wander) {
    return make("shelfstone", {{"field", as_value(wall)},
                               {"levels", List{Value(0.3), Value(-0.4)}},
                               {"width", 0.12},
                               {"wander", wander},
                               {"thickness", 0.03},
                               {"rim", 0.01}});
  };
  const Field even = shelf_of(0), uneven = shelf_of(0.6);
  for (const double level : {0.3, -0.4}) {
    for (int i = 0; i < 200; ++i) {
      const double z = 0.03 * i;
      EXPECT_LT(even.value({0.119, level - 1e-6, z}), 0);
      EXPECT_GT(even.value({0.119, level + 1e-6, z}), 0);
      EXPECT_GT(even.value({0.121, level - 1e-6, z}), 0);
      EXPECT_LT(uneven.value({0.02, level - 1e-6, z}), 0);
      EXPECT_GT(uneven.value({0.02, level + 1e-6, z}), 0);
      EXPECT_LT(even.value({0.06, level - 0.0199, z}), 0);  // Half-way from root to rim.
      EXPECT_GT(even.value({0.06, level - 0.0201, z}), 0);
    }
  }
  // The rim wanders about its mean.
  double sum = 0, least = 1, most = 0;
  const int count = 4000;
  for (int i = 0; i < count; ++i) {
    double low = 0, high = 0.3;
    for (int k = 0; k < 30; ++k) {
      const double middle = 0.5 * (low + high);
      (uneven.value({middle, 0.3 - 1e-4, 0.1 * i}) < 0 ? low : high) = middle;
    }
    sum += low;
    least = std::min(least, low);
    most = std::max(most, low);
  }
  EXPECT_NEAR(sum / count, 0.12, 0.01);
  EXPECT_LT(least, 0.08);
  EXPECT_GT(most, 0.16);
  EXPECT_LE(most, 0.12 * 1.6 + 1e-6);
}

// What has grown is calcite, the wall below stays limestone, and distances do not change.
TEST(SmallSpeleothems, HaveAMaterialOfTheirOwn) {
  const Field bare = make("half_space", {{"normal", Vec3d(1, 0, 0)}}), wall = of(bare, "limestone");
  const auto weight_at = [](const Field& field, const Vec3d& p) {
    return sample_materials(*field.node(), p).mix.weight("calcite");
  };
  for (const char* kind : {"shelfstone", "cave_clouds", "popcorn"}) {
    NamedValues values = {{"field", as_value(wall)}};
    if (std::string(kind) != "shelfstone") {
      values.emplace_back("from", Vec3d(-0.2, -0.3, -0.3));
      values.emplace_back("to", Vec3d(0.2, 0.3, 0.3));
    }
    const Field plain = make(kind, values);
    EXPECT_TRUE(sample_materials(*plain.node(), {0.01, -0.1, 0}).mix.weight("limestone") > 0);
    values.emplace_back("material", "calcite");
    const Field grown = make(kind, values);
    int own = 0;
    RandomStream random(RandomKey(6));
    for (int i = 0; i < 4000; ++i) {
      const double x = random.uniform(-0.02, 0.06), y = random.uniform(-0.3, 0.02);
      const Vec3d p(x, y, random.uniform(-0.3, 0.3));
      EXPECT_EQ(grown.value(p), plain.value(p)) << kind;
      if (x > 0.002 && grown.value(p) < -0.001) {
        EXPECT_GT(weight_at(grown, p), 0.999) << kind << ' ' << p;
        ++own;
      }
    }
    EXPECT_GT(own, 20) << kind;
    EXPECT_EQ(weight_at(grown, {-0.15, -0.1, 0.05}), 0) << kind;
    for (auto& [name, value] : values)
      if (name == "field") value = as_value(bare);
    EXPECT_THROW(make(kind, values), Error) << kind;
  }
}

TEST(RandomCurve, HasTheStatedCurvatureInAllDirections) {
  RandomStream random(RandomKey(5));
  const RandomCurve shape{200, 0.05, 0.4, 2};
  const auto curve = random_curve(shape, Vec3d(1, 2, 3), level_frame({0, -1, 0}), random);
  EXPECT_EQ(curve.front().at, Vec3d(1, 2, 3));
  double squares = 0, arc = 0;
  Vec3d mean(0);
  for (size_t i = 0; i + 1 < curve.size(); ++i) {
    arc += (curve[i + 1].at - curve[i].at).length();
    mean += curve[i].frame.tangent / static_cast<double>(curve.size());
    const double turn =
        std::acos(std::min(1.0, curve[i].frame.tangent.dot(curve[i + 1].frame.tangent)));
    squares += turn * turn / (0.05 * 0.05) / static_cast<double>(curve.size() - 1);
  }
  EXPECT_NEAR(arc, 200, 1e-9);
  EXPECT_NEAR(std::sqrt(squares / 2), 0.4, 0.06);  // Two components.
  EXPECT_LT(mean.length(), 0.35);                  // No direction is preferred.
}

TEST(Helictite, BendsOverFiveRadiiAndKeepsItsLength) {
  const Field one =
      make("helictite", {{"length", 0.1}, {"radius", 0.002}, {"branches", 0.0}, {"root", 0.0}});
  const Box3d box = one.bounds();
  EXPECT_LT(box.size().length(), 0.11);
  EXPECT_GT(box.size().length(), 0.02);
  EXPECT_NEAR(one.value({0, 0, 0}), -0.002, 1e-4);
  const Field straight =
      make("helictite",
           {{"length", 0.1}, {"radius", 0.002}, {"curl", 0.0}, {"branches", 0.0}, {"root", 0.0}});
  EXPECT_NEAR(straight.value({0, -0.1, 0}), -0.002 * (1 - 2 * 0.1), 1e-9);  // 2 % per cm.
  EXPECT_NEAR(straight.value({0.01, -0.05, 0}), 0.01 - 0.002 * 0.9, 1e-5);
}

TEST(Shield, IsTwoPlatesOnEitherSideOfACrack) {
  const Vec3d normal = Vec3d(1, 2, -0.5).normalized();
  const Field shield = make("shield", {{"diameter", 1.4},
                                       {"thickness", 0.05},
                                       {"edge", 0.02},
                                       {"crack", 0.001},
                                       {"core", 0.1},
                                       {"normal", normal}});
  const auto [u, v] = tangents(normal);
  for (int i = 0; i < 24; ++i) {
    const Vec3d way = u * std::cos(0.26 * i) + v * std::sin(0.26 * i);
    EXPECT_NEAR(shield.value(way * 0.5), 0.0005, 1e-9);      // The middle of the crack.
    EXPECT_LT(shield.value(way * 0.5 + normal * 0.001), 0);  // The plates ...
    EXPECT_LT(shield.value(way * 0.5 - normal * 0.001), 0);
    EXPECT_LT(shield.value(way * 0.03), 0);                   // ... are joined in the middle
    EXPECT_GT(shield.value(way * 0.701 + normal * 0.01), 0);  // ... and end at the radius.
    EXPECT_LT(shield.value(way * 0.699 + normal * 0.01), 0);
    EXPECT_NEAR(shield.value(way * 0.4 + normal * 0.2), shield.value(way * 0.4 - normal * 0.2),
                1e-9);
  }
  EXPECT_NEAR(shield.value(normal * 0.1), 0.1 - 0.0505, 0.004);
}

TEST(CavePearls, LieInTheBowlWithoutOverlap) {
  RandomStream random(RandomKey(8));
  const PearlBowl bowl{0.09, 0.03};
  std::vector<double> radii;
  for (int i = 0; i < 120; ++i)
    radii.push_back(0.0075 * std::exp(0.3 * std::clamp(random.normal(), -2.0, 2.0)));
  const std::vector<Lobe> pearls = packed_pearls(bowl, radii, random);
  EXPECT_GT(pearls.size(), 60u);
  const Vec3d middle(0, bowl.curvature(), 0);
  for (size_t i = 0; i < pearls.size(); ++i) {
    const double inside =
        bowl.curvature() - (pearls[i].centre - middle).length() - pearls[i].radius;
    EXPECT_GT(inside, -1e-9);
    double touch = inside;  // Each rests on something.
    for (size_t k = 0; k < pearls.size(); ++k) {
      if (k == i) continue;
      const double gap =
          (pearls[i].centre - pearls[k].centre).length() - pearls[i].radius - pearls[k].radius;
      EXPECT_GT(gap, -1e-9);
      touch = std::min(touch, gap);
    }
    EXPECT_LT(touch, 1e-9);
  }
}

TEST(TravertineDome, HasTheProfileOfItsClosedForm) {
  for (const double degrees : {5.0, 30.0, 60.0, 80.0}) {
    const double t = degrees * kDegree, s = std::tan(t);
    EXPECT_NEAR(dome_radius(s), std::sqrt(std::sin(t) / std::pow(std::cos(t), 3)),
                1e-12 * dome_radius(s));
    // The slope of the curve is the tangent.
    const double step = 1e-5 * s;
    EXPECT_NEAR((dome_depth(s + step) - dome_depth(s - step)) /
                    (dome_radius(s + step) - dome_radius(s - step)),
                s, 1e-6 * s);
  }
  EXPECT_NEAR(dome_depth(1e-4) / (std::pow(dome_radius(1e-4), 3) / 3), 1, 1e-6);  // Flat on top.
  const std::vector<Vec2d> side = dome_points(0.5, 70 * kDegree, 48);
  EXPECT_EQ(side.front().y, 0);
  EXPECT_NEAR(side.front().x, 0.5, 1e-12);
  EXPECT_EQ(side.back().x, 0);
}

}  // namespace
}  // namespace vug::field
