// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <gtest/gtest.h>

#include <cmath>

namespace vug::sgm {
namespace {

void expect_on_surface(const Field& f, const std::vector<Bond>& bonds) {
  const double size = size_of(f);
  for (const Bond& bond : bonds) {
    EXPECT_NEAR(f.value(bond.point), 0, 1e-9 * size);
    if (!bond.free_direction()) {
      EXPECT_NEAR(bond.direction.length(), 1, 1e-12);
      EXPECT_GT(f.value(bond.point + bond.direction * (1e-4 * size)), 0);
    }
  }
}

// Figure 6: the bonds of a cuboid are at the centres of its faces.
TEST(BondsOf, ACuboid) {
  const Field f = moved(box({1, 2, 3}), {10, 20, 30});
  const auto bonds = bonds_of(f);
  ASSERT_EQ(bonds.size(), 6u);
  for (int s = 0; s < 6; ++s) {
    const auto side = static_cast<size_t>(s);
    const Vec3d d = direction(static_cast<Label>(s));
    EXPECT_EQ(bonds[side].direction, d);
    const Vec3d face = Vec3d(10, 20, 30) + d * Vec3d(1, 2, 3);
    EXPECT_LT((bonds[side].point - face).length(), 1e-12);
  }
}

TEST(BondsOf, ATorusHasSupportPointsAlongItsHole) {
  const Field f = torus(1, 0.25);
  const auto bonds = bonds_of(f);
  ASSERT_EQ(bonds.size(), 6u);
  expect_on_surface(f, bonds);
  EXPECT_LT((bonds[1].point - Vec3d(1.25, 0, 0)).length(), 1e-12);
  for (const size_t along : {2u, 3u}) {
    EXPECT_NEAR(std::fabs(bonds[along].point.y), 0.25,
                1e-5);  // Support points are accurate to 1e-6 of the size.
    EXPECT_NEAR(std::hypot(bonds[along].point.x, bonds[along].point.z), 1, 1e-2);
  }
}

TEST(BondsOf, AnEmptyMiddleFallsBackToTheSupportPoint) {
  // Two balls next to each other: the ray along y passes between them.
  const Field f = field::unite({moved(ball(1), {-3, 0, 0}), moved(ball(1), {3, 0, 0})});
  const auto top = bond_on(f, Label::plus_y);
  ASSERT_TRUE(top);
  EXPECT_NEAR(top->point.y, 1, 1e-5);
  // A cup, open towards +x: the ray enters it and would meet its far wall from inside.
  const Field cup = field::subtract(box({1, 1, 1}), {moved(box({1, 0.5, 0.5}), {0.5, 0, 0})});
  const auto right = bond_on(cup, Label::plus_x);
  ASSERT_TRUE(right);
  EXPECT_NEAR(right->point.x, 1, 1e-9);
  EXPECT_GT(std::max(std::fabs(right->point.y), std::fabs(right->point.z)), 0.5 - 1e-6);
}

TEST(BondsOf, InfiniteSolids) {
  const Field ground = solid(TestHalfSpace{{0, 1, 0}, {0, 2, 0}});
  const auto bonds = bonds_of(ground);
  ASSERT_EQ(bonds.size(), 1u);
  EXPECT_LT((bonds[0].point - Vec3d(0, 2, 0)).length(), 1e-9);
  EXPECT_EQ(bonds[0].direction, Vec3d(0, 1, 0));

  const double h = std::sqrt(0.5);
  const Field tilted = solid(TestHalfSpace{{h, h, 0}, {1, 1, 0}});
  const auto free = bonds_of(tilted);
  ASSERT_EQ(free.size(), 1u);
  EXPECT_TRUE(free[0].free_direction());
  EXPECT_NEAR(tilted.value(free[0].point), 0, 1e-9);

  EXPECT_TRUE(bonds_of(Field()).empty());
}

// For all existing kinds: bonds lie on the surface and point outwards.
TEST(BondsOf, EveryPrimitiveKind) {
  for (const field::FieldKind* kind : field::primitives()) {
    Diagnostics diagnostics;
    const auto f = kind->make({}, {}, diagnostics);
    if (!f) continue;  // Requires a file or another field.
    SCOPED_TRACE(kind->info.name);
    const auto bonds = bonds_of(*f);
    expect_on_surface(*f, bonds);
    if (is_finite(f->bounds())) {
      EXPECT_EQ(bonds.size(), 6u);
    } else if (!f->bounds().isEmpty()) {
      EXPECT_FALSE(bonds.empty());
    }
  }
}

TEST(Transformed, TransformsBonds) {
  const Transform map = Transform::translation({1, 2, 3}) * Transform::rotation({0, 1, 0}, kPi / 2);
  const Shape shape = transformed(make_shape("box", box({1, 2, 3})), map);
  expect_on_surface(shape.field, shape.bonds);
  EXPECT_LT((shape.bonds[1].direction - Vec3d(0, 0, -1)).length(), 1e-12);  // +x rotated to -z.
}

}  // namespace
}  // namespace vug::sgm
