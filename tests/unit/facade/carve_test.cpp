// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

#include <vug/facade/carve.h>
#include <vug/facade/outline.h>
#include <vug/field/registry.h>

#include <cmath>

namespace vug::facade {
namespace {

field::Field wall_of(const std::string& rules, FacadeFrame frame = {}, double width = 12,
                     double height = 9) {
  const Sample s = facade_of(rules, 0, width, height);
  EXPECT_EQ(s.said, "");
  return wall(std::make_shared<const Tree>(s.tree), frame, 0.6);
}

/// A facade with every kind of element with default parameters, in planes behind and in front of
/// the wall's.
field::Field everything() {
  std::string rules =
      "axiom A\n A -> rows(1, B, 1, recess(40cm, C, front: D), 1, project(30cm, E))\n";
  std::string list;
  for (const ElementKind* kind : elements()) list += ", 1, " + kind->info.name;
  for (const char* head : {"B", "C", "D", "E"})
    rules += std::string(head) + " -> columns(1, wall" + list + ")\n";
  return wall_of(rules, {}, 24, 12);
}

Vec3d random_point(RandomStream& random) {
  return {random.uniform(-13, 13), random.uniform(-1, 13), random.uniform(-2, 2)};
}

TEST(Carve, HolesAndProjections) {
  const field::Field f = wall_of(
      "axiom A\n A -> columns(4m, inset(1m, window(reveal: 20cm, sash: 0cm)), 4m, wall(relief: "
      "30cm), "
      "4m, doorway(depth: 2m))");
  EXPECT_GT(f.value({-4, 4.5, -0.1}), 0) << "in the window";
  EXPECT_LT(f.value({-4, 4.5, -0.5}), 0) << "behind it";
  EXPECT_LT(f.value({-5.5, 4.5, -0.1}), 0) << "next to it";
  EXPECT_LT(f.value({0, 4, 0.2}), 0) << "raised wall";
  EXPECT_GT(f.value({4, 4, -0.5}), 0) << "a passage through the wall";
  EXPECT_GT(f.value({0, 4, 0.4}), 0);
}

TEST(Carve, OffsetPlanes) {
  const field::Field f = wall_of(
      "axiom A\n A -> columns(1, recess(30cm, wall), 1, project(40cm, inset(1m, window(sash: "
      "0cm))))");
  EXPECT_GT(f.value({-3, 4, -0.2}), 0);
  EXPECT_LT(f.value({-3, 4, -0.4}), 0);
  EXPECT_LT(f.value({0.5, 4, 0.3}), 0);
  EXPECT_GT(f.value({3, 4, 0.3}), 0) << "windows are holes in projected parts, too";
}

TEST(Carve, MirroredElementsAreMirrored) {
  const field::Field f =
      wall_of("axiom A\n A -> mirror(Side)\n Side -> columns(1m, window(sash: 0cm), 1, wall)");
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 500; ++i) {
    const Vec3d p = random_point(random);
    EXPECT_NEAR(f.value(p), f.value({-p.x, p.y, p.z}), 1e-9);
  }
}

TEST(Carve, IsPlacedByItsFrame) {
  const std::string rules = "axiom A\n A -> doorway(depth: 30cm)";
  const field::Field here = wall_of(rules), there = wall_of(rules, {{5, 1, 2}, kPi / 2});
  // Rotated to the left by a right angle it faces +x.
  EXPECT_NEAR(there.value({5 - 0.1, 5, 2}), here.value({0, 4, -0.1}), 1e-9);
  EXPECT_NEAR(there.value({5 - 0.1, 5, 2 - 5}), here.value({5, 4, -0.1}), 1e-9);
}

TEST(Carve, FieldTraitsHold) {
  const field::Field f = everything();
  RandomStream random(RandomKey(7));
  EXPECT_LE(f.lipschitz(), 1 + 1e-9);
  for (int i = 0; i < 4000; ++i) {
    const Vec3d p = random_point(random), q = p + 0.3 * (random_point(random) / 13);
    const double a = f.value(p), b = f.value(q);
    ASSERT_TRUE(std::isfinite(a));
    ASSERT_LE(std::abs(a - b), f.lipschitz() * (p - q).length() * (1 + 1e-6) + 1e-9);
    if (a < 0) {
      ASSERT_TRUE(f.bounds().intersects(p));
    }
    if (i % 8) continue;
    const field::Ball ball{p, 0.4};
    const auto part = f.restricted(ball);
    const Interval box = f.interval({p - Vec3d(0.2), p + Vec3d(0.2)});
    for (int j = 0; j < 8; ++j) {
      const Vec3d r = p + Vec3d(random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2),
                                random.uniform(-0.2, 0.2));
      const double value = f.value(r);
      ASSERT_NEAR(part.field.value(r), value, 1e-9);
      ASSERT_TRUE(value >= part.range.lo - 1e-6 && value <= part.range.hi + 1e-6);
      ASSERT_TRUE(value >= box.lo - 1e-9 && value <= box.hi + 1e-9);
    }
  }
}

TEST(Carve, GradientsMatchTheValues) {
  const field::Field f = everything();
  RandomStream random(RandomKey(8));
  int smooth = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d p = random_point(random);
    const Vec3d g = f.gradient(p).gradient;
    ASSERT_LE(g.length(), 1 + 1e-6);
    constexpr double h = 1e-6;
    const Vec3d d((f.value(p + Vec3d(h, 0, 0)) - f.value(p - Vec3d(h, 0, 0))) / (2 * h),
                  (f.value(p + Vec3d(0, h, 0)) - f.value(p - Vec3d(0, h, 0))) / (2 * h),
                  (f.value(p + Vec3d(0, 0, h)) - f.value(p - Vec3d(0, 0, h))) / (2 * h));
    smooth += (g - d).length() < 1e-4;
  }
  EXPECT_GT(smooth, 1960) << "all but those on a crease";
}

TEST(Carve, WeatheringLeavesHolesOpen) {
  for (const char* kind :
       {"window", "door", "doorway", "niche", "panel(depth: 5cm)", "wall(relief: -5cm)"}) {
    const field::Field f = wall_of(std::string("axiom A\n A -> inset(2m, ") + kind + ")");
    // The field values there are upper bounds of displacements of the carved wall.
    for (double z = 0; z < 1; z += 0.005)
      ASSERT_GE(f.value({0.3, 4.6, z}), std::min(0.05, z + 0.05) - 1e-9) << kind << ' ' << z;
  }
}

TEST(Carve, ElementsReportInvalidDimensions) {
  const Sample s =
      facade_of("axiom A\n A -> columns(10cm, column(base: 3, capital: 3), 1, wall)", 0, 12, 0.3);
  try {
    carve(s.tree);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("column 'column' of 0.1 x 0.3 m"), std::string::npos)
        << error.what();
  }
}

TEST(Carve, TinyElementsOfThePublishedGrammarAreValid) {
  for (const char* kind : {"window", "door", "shop", "doorway"})
    for (const double size : {1e-3, 0.03, 0.2}) {
      const Sample s = facade_of(std::string("axiom A\n A -> ") + kind, 0, size, 2 * size);
      EXPECT_NO_THROW(carve(s.tree)) << kind << ' ' << size;
    }
}

TEST(Carve, ZonesAndInfill) {
  const Sample s = facade_of("axiom A\n A -> columns(1, inset(1m, window), 1, inset(1m, door))");
  const field::Field windows = zones(s.tree, {"window"}, 0.5, 0.5);
  EXPECT_LT(windows.value({3, 4, 0}), 0);
  EXPECT_GT(windows.value({9, 4, 0}), 0);
  const field::Field fill = carve(s.tree).fill;
  EXPECT_LT(fill.value({9, 4, -0.25}), 0) << "the door's leaf";
  EXPECT_NEAR(fill.value({3, 4, -0.258}), -0.03, 1e-9) << "panes are as thick as a voxel";
}

TEST(Outline, DistancesAreExact) {
  // An L: the distance to its outline by brute force.
  const Outline ell = {{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const field::Field f = extruded(ell, -50, 50), t = revolved(ell);
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 2000; ++i) {
    const double x = random.uniform(-1, 3), y = random.uniform(-1, 4);
    double least = 1e9, least_turned = 1e9;
    for (size_t k = 0; k < ell.size(); ++k) {
      const Vec2d a = ell[k], b = ell[(k + 1) % ell.size()], e = b - a, w = Vec2d(x, y) - a;
      const double along = std::clamp(w.dot(e) / e.dot(e), 0.0, 1.0);
      least = std::min(least, (w - e * along).length());
      if (a.x > 0 || b.x > 0) least_turned = std::min(least_turned, (w - e * along).length());
    }
    const bool inside = x > 0 && y > 0 && y < 3 && x < (y < 1 ? 2 : 1);
    EXPECT_NEAR(f.value({x, y, 0}), inside ? -least : least, 1e-9);
    if (x >= 0) {
      EXPECT_NEAR(t.value({0, y, x}), inside ? -least_turned : least_turned, 1e-9);
    }
  }
}

}  // namespace
}  // namespace vug::facade
