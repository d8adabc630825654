// SPDX-License-Identifier: Apache-2.0
// The core of expressions: evaluation modes agree, and restriction changes nothing inside its ball.
#include "random_point.h"

#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

Field sphere_at(const Vec3d& centre, double radius) {
  return transformed(make("sphere", {{"radius", radius}}), Transform::translation(centre));
}

TEST(Field, MorphOfConcentricSpheresIsASphere) {
  const Field f = morph(make("sphere", {{"radius", 1.0}}), make("sphere", {{"radius", 3.0}}), 0.25);
  EXPECT_NEAR(f.value({0, 1.5, 0}), 0, 1e-15);
}

TEST(Field, MorphsAtTheEndsAreTheOperands) {
  const Field a = make("sphere"), b = sphere_at({1, 0, 0}, 2);
  EXPECT_EQ(morph(a, b, 0).node(), a.node());
  EXPECT_EQ(morph(a, b, 1).node(), b.node());
}

TEST(Field, SharedNodesAreCountedOnceAndVisitedInEachPlace) {
  Field f = make("sphere");
  for (int i = 0; i < 60; ++i) f = unite({f, complement(f)});
  EXPECT_LE(node_count(f), 121);
  EXPECT_GT(extent(f).visits, std::ldexp(1.0, 60));
  EXPECT_EQ(extent(f).depth, 121);
  EXPECT_EQ(extent(make("sphere")).visits, 1);
}

TEST(Field, DeMorganHolds) {
  const Field a = sphere_at({0.5, 0, 0}, 1), b = sphere_at({-0.5, 0.2, 0}, 1.2);
  RandomStream random(RandomKey(1));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 3);
    EXPECT_EQ(complement(unite({a, b})).value(p),
              intersect({complement(a), complement(b)}).value(p));
    EXPECT_EQ(subtract(a, {b}).value(p), intersect({a, complement(b)}).value(p));
    EXPECT_GE(subtract(a, {a}).value(p), 0);
  }
}

TEST(Field, RestrictionKeepsValuesAndDropsOperands) {
  for (const Profile profile :
       {Profile::sharp, Profile::smooth, Profile::round, Profile::chamfer}) {
    const Blend blend{profile, profile == Profile::sharp ? 0 : 0.3};
    std::vector<Field> spheres;
    RandomStream random(RandomKey(2));
    for (int i = 0; i < 200; ++i)
      spheres.push_back(sphere_at(random_point(random, 5), random.uniform(0.3, 0.8)));
    const Field all = unite(spheres, blend);
    size_t nodes = 0;
    for (int i = 0; i < 100; ++i) {
      const Ball ball{random_point(random, 5), 0.4};
      const Field::RestrictedField part = all.restricted(ball);
      nodes += node_count(part.field);
      for (int j = 0; j < 20; ++j) {
        const Vec3d p = ball.centre + random_point(random, 0.4 / std::sqrt(3.0));
        EXPECT_EQ(part.field.value(p), all.value(p));
        EXPECT_TRUE(part.range.contains(all.value(p)));
      }
    }
    EXPECT_LT(nodes, 100u * 60);  // Of 401.
  }
}

TEST(Field, BatchesAgreeWithScalars) {
  const Field f = subtract(
      unite({sphere_at({0.5, 0, 0}, 1), sphere_at({-1, 0, 0}, 0.7)}, {Profile::round, 0.4}),
      {morph(make("sphere"), sphere_at({0, 1, 0}, 0.5), 0.3)});
  RandomStream random(RandomKey(3));
  Scratch scratch;
  Point<Pack> points[4];
  Vec3d where[4][8];
  for (int k = 0; k < 4; ++k) {
    float x[8], y[8], z[8];
    for (int lane = 0; lane < 8; ++lane) {
      where[k][lane] = Vec3d(Vec3f(random_point(random, 2)));
      x[lane] = static_cast<float>(where[k][lane].x);
      y[lane] = static_cast<float>(where[k][lane].y);
      z[lane] = static_cast<float>(where[k][lane].z);
    }
    points[k] = {Pack::load(x), Pack::load(y), Pack::load(z)};
  }
  Pack out[4];
  f.values(points, 4, out, scratch);
  Dual<Pack> slopes[4];
  f.gradients(points, 4, slopes, scratch);
  for (int k = 0; k < 4; ++k) {
    float values[8], dx[8];
    out[k].store(values);
    slopes[k].dx.store(dx);
    for (int lane = 0; lane < 8; ++lane) {
      EXPECT_NEAR(values[lane], f.value(where[k][lane]), 1e-6);
      EXPECT_NEAR(dx[lane], f.gradient(where[k][lane]).gradient.x, 1e-5);
    }
  }
}

}  // namespace
}  // namespace vug::field
