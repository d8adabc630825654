// SPDX-License-Identifier: Apache-2.0
// Deformers compared with closed forms and with explicit copies or maps.
#include "random_point.h"

#include <vug/base/maths.h>
#include <vug/base/rng.h>
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

using Parameters = std::vector<std::pair<std::string, Value>>;

Field ball(const Vec3d& centre, double radius) {
  return transformed(make("sphere", {{"radius", radius}}), Transform::translation(centre));
}

Field deformed(const std::string& kind, const Field& field, Parameters params) {
  params.push_back({"field", as_value(field)});
  return make(kind, params);
}

/// A ball off the centre of its cell, large enough to extend beyond it.
TEST(Deformer, RepeatIsTheUnionOfItsCopies) {
  for (const double radius : {0.2, 0.6, 1.3}) {
    const Field one = ball({0.35, 0.1, -0.4}, radius);
    const Field rows =
        deformed("repeat", one, {{"spacing", Vec3d(1, 1.5, 0)}, {"counts", Vec3d(4, 3, 0)}});
    std::vector<Field> copies;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 3; ++j)
        copies.push_back(transformed(one, Transform::translation({i - 1.5, 1.5 * (j - 1), 0})));
    const Field all = unite(copies);
    RandomStream random(RandomKey(1));
    for (int i = 0; i < 3000; ++i) {
      const Vec3d p = random_point(random, 6);
      if (all.value(p) >= 0) {
        EXPECT_NEAR(rows.value(p), all.value(p), 1e-12) << radius;
      }
      EXPECT_EQ(rows.value(p) < 0, all.value(p) < 0);
      const Field::RestrictedField part = rows.restricted({p, 0.3});
      EXPECT_NEAR(part.field.value(p), std::min(rows.value(p), all.value(p)), 1e-12);
      EXPECT_TRUE(part.range.contains(rows.value(p)));
    }
    EXPECT_EQ(rows.bounds().max.x, all.bounds().max.x);
  }
}

TEST(Deformer, InfiniteRepeatIsPeriodicAndPrunesToOneCopy) {
  const Field rows = deformed("repeat", ball({0, 0, 0}, 0.3), {{"spacing", Vec3d(1, 1, 1)}});
  RandomStream random(RandomKey(2));
  for (int i = 0; i < 1000; ++i) {
    const Vec3d p = random_point(random, 0.5);
    EXPECT_NEAR(rows.value(p), p.length() - 0.3, 1e-15);
    EXPECT_NEAR(rows.value(p + Vec3d(100, -7, 3)), rows.value(p), 1e-12);
  }
  EXPECT_LE(node_count(rows.restricted({{0.2, 0.1, 0}, 0.05}).field),
            3u);  // Two translations of a ball.
}

TEST(Deformer, PolarRepeatAndMirrorPlaceTheirCopies) {
  const Field ring = deformed("polar_repeat", ball({2, 0, 0}, 0.5), {{"count", 5}});
  for (int i = 0; i < 5; ++i) {
    const double angle = 2 * kPi * i / 5;
    EXPECT_NEAR(ring.value({2 * std::cos(angle), 0, -2 * std::sin(angle)}), -0.5, 1e-12);
  }
  const Field pair = deformed("mirror", ball({1, 2, 3}, 0.5), {{"normal", Vec3d(0, 1, 0)}});
  EXPECT_NEAR(pair.value({1, -2, 3}), -0.5, 1e-15);
  EXPECT_NEAR(pair.value({1, 2, 3}), -0.5, 1e-15);
}

TEST(Deformer, RotateAndScalePreserveDistances) {
  const Field turned = deformed("rotate", ball({1, 0, 0}, 0.25),
                                {{"angle", Number{kPi / 2, Dimension::angle}},
                                 {"axis", Vec3d(0, 0, 1)},
                                 {"pivot", Vec3d(1, 1, 0)}});
  EXPECT_NEAR(turned.value({2, 1, 0}), -0.25, 1e-12);
  EXPECT_EQ(turned.exactness(), Exactness::exact);
  const Field large = deformed("scale", ball({1, 0, 0}, 0.25), {{"by", 3.0}});
  EXPECT_NEAR(large.value({5, 0, 0}), 2 - 0.75, 1e-12);
  const Field flat = deformed("scale", ball({0, 0, 0}, 1), {{"by", Vec3d(3, 0.5, 1)}});
  EXPECT_NEAR(flat.value({3, 0, 0}), 0, 1e-12);
  EXPECT_NEAR(flat.value({0, 0.5, 0}), 0, 1e-12);
  EXPECT_EQ(flat.exactness(), Exactness::bound);
}

/// The surface moves to where the forward map takes it.
TEST(Deformer, TwistBendAndTaperMoveTheSurfaceByTheirMaps) {
  const Field one = ball({0.5, 0.4, 0}, 0.6);
  const Field twisted = deformed("twist", one, {{"rate", 2.0}});
  const Field bent = deformed("bend", one, {{"rate", 0.5}});
  const Field down = deformed("bend", one, {{"rate", -0.5}});
  const Field tapered = deformed("taper", one, {{"from", 1.0}, {"to", 0.25}});
  RandomStream random(RandomKey(3));
  for (int i = 0; i < 2000; ++i) {
    Vec3d way = random_point(random, 1);
    if (way.length() < 0.1) continue;
    const Vec3d q = Vec3d(0.5, 0.4, 0) + 0.6 * way.normalized();
    const double a = 2 * q.y;
    const Vec3d onto_twist(std::cos(a) * q.x + std::sin(a) * q.z, q.y,
                           -std::sin(a) * q.x + std::cos(a) * q.z);
    EXPECT_NEAR(twisted.value(onto_twist), 0, 1e-9);
    auto wound = [&](double y) {
      return Vec3d((2 - y) * std::sin(q.x / 2), 2 - (2 - y) * std::cos(q.x / 2), q.z);
    };
    EXPECT_NEAR(bent.value(wound(q.y)), 0, 1e-9);
    const Vec3d mirrored = wound(-q.y);
    EXPECT_NEAR(down.value({mirrored.x, -mirrored.y, mirrored.z}), 0, 1e-9);
    const double factor = 1 - 0.75 * (q.y + 0.2) / 1.2;
    EXPECT_NEAR(tapered.value({q.x * factor, q.y, q.z * factor}), 0, 1e-9);
  }
}

TEST(Deformer, TheHollowOfABendIsEmpty) {
  const Field bar = make("box", {{"size", Vec3d(2, 0.4, 0.6)}});
  const Field arch = deformed("bend", bar, {{"rate", 1.2}});
  const double radius = 1 / 1.2, inner = radius - 0.2;
  RandomStream random(RandomKey(5));
  for (int i = 0; i < 1000; ++i) {
    const double rho = inner * std::sqrt(random.uniform()), angle = random.uniform(0, 2 * kPi);
    const Vec3d p(rho * std::sin(angle), radius - rho * std::cos(angle), random.uniform(-1, 1));
    EXPECT_GE(arch.value(p), inner - rho - 1e-12) << p;
  }
}

TEST(Deformer, EdgesOfATwistOrTaperHaveNoArtefacts) {
  const Field bar = make("box", {{"size", Vec3d(0.7, 2, 0.7)}});
  const Field twisted = deformed("twist", bar, {{"rate", 1.0}});
  const Field tapered = deformed("taper", bar, {{"from", 1.3}, {"to", 0.3}});
  const double corner = 0.35 * std::sqrt(2.0);
  RandomStream random(RandomKey(6));
  for (int i = 0; i < 1000; ++i) {
    // On and beyond the vertical edges, where the maps project points onto the corners of the box.
    const double y = random.uniform(-0.99, 0.99), away = random.uniform(1e-6, 0.5);
    const double turn = 0.25 * kPi - y;
    const Vec3d beside((corner + away) * std::cos(turn), y, (corner + away) * std::sin(turn));
    EXPECT_GE(twisted.value(beside), away - 1e-12) << beside;
    const double factor = 1.3 - 0.5 * (y + 1), side = (corner * factor + away) / std::sqrt(2.0);
    const double steep = std::sqrt(1 + 0.25 * corner * corner);
    EXPECT_GE(tapered.value({side, y, -side}), away / steep - 1e-12) << side << y;
  }
}

TEST(Deformer, ClaimsHoldForEachDeformer) {
  const Field one = ball({0.3, 0.1, 0}, 0.7);
  const std::vector<std::pair<std::string, Field>> fields = {
      {"twist", deformed("twist", one, {{"rate", 1.5}})},
      {"bend", deformed("bend", one, {{"rate", 0.8}})},
      {"bend wide",
       deformed("bend", deformed("scale", one, {{"by", Vec3d(4, 0.5, 0.5)}}), {{"rate", 0.7}})},
      {"taper", deformed("taper", one, {{"to", 0.3}, {"axis", Vec3d(1, 1, 0)}})},
      {"warp", deformed("warp", one, {{"amount", 0.2}})},
      {"repeat", deformed("repeat", one, {{"spacing", Vec3d(1, 1, 2)}})},
  };
  for (const auto& [name, f] : fields) {
    RandomStream random(RandomKey(4));
    const bool bound = f.exactness() != Exactness::sign;
    for (int i = 0; i < 3000; ++i) {
      const Vec3d p = random_point(random, 3), q = p + random_point(random, 0.05);
      ASSERT_LE(std::fabs(f.value(p) - f.value(q)), f.lipschitz() * (p - q).length() + 1e-12)
          << name << p << q;
      if (bound) {
        ASSERT_LE(f.lipschitz(), 2 + 1e-9) << name;
      }
      if (f.value(p) <= 0) {
        ASSERT_TRUE(f.bounds().intersects(p)) << name;
      }
    }
    for (int i = 0; i < 200; ++i) {
      const Ball region{random_point(random, 3), random.uniform(0.01, 0.5)};
      const Field::RestrictedField part = f.restricted(region);
      const Vec3d corner(region.radius / std::sqrt(3.0));
      const Interval box = f.interval({region.centre - corner, region.centre + corner});
      for (int k = 0; k < 20; ++k) {
        const Vec3d p = region.centre + random_point(random, region.radius / std::sqrt(3.0));
        ASSERT_NEAR(part.field.value(p), f.value(p), 1e-12) << name;
        ASSERT_TRUE(part.range.contains(f.value(p))) << name;
        ASSERT_TRUE(box.contains(f.value(p))) << name;
      }
    }
  }
}

TEST(Deformer, FaultsAreDiagnosed) {
  const Field one = ball({0, 0, 0}, 1);
  EXPECT_THROW(deformed("bend", one, {{"rate", 2.0}}), Error);
  EXPECT_THROW(deformed("twist", complement(one), {}), Error);
  EXPECT_THROW(
      deformed("rotate", one, {{"angle", Number{1, Dimension::angle}}, {"axis", Vec3d(0)}}), Error);
  EXPECT_THROW(deformed("repeat", one, {{"counts", Vec3d(1.5, 0, 0)}}), Error);
}

}  // namespace
}  // namespace vug::field
