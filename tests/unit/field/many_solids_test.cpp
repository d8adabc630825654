// SPDX-License-Identifier: Apache-2.0
// Unions of many solids skip operands that cannot matter: their values stay those of the plain
// minimum, to the bit, with and without a restriction.
#include <vug/field/affine.h>
#include <vug/field/boolean.h>
#include <vug/field/box_lanes.h>
#include <vug/field/lathe.h>
#include <vug/field/registry.h>
#include <vug/field/speleothems/deposits.h>
#include <vug/field/speleothems/drapery_sheet.h>
#include <vug/field/speleothems/element_field.h>
#include <vug/field/speleothems/nodule.h>
#include <vug/field/speleothems/turned.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "random_point.h"

namespace vug::field {
namespace {

constexpr int kPacks = 70;  // More than BoxLanes takes at a time.

using Values = std::array<std::array<float, Pack::kLanes>, kPacks>;

Vec3d point_in(RandomStream& random, const Ball& ball) {
  const Vec3d offset = random_point(random, 1);
  return ball.centre + offset * (0.999 * ball.radius / std::max(1.0, offset.length()));
}

/// Points in a ball, eight on a line as the voxels of a block.
std::vector<Point<Pack>> rows(RandomStream& random, const Ball& ball) {
  std::vector<Point<Pack>> out;
  for (int k = 0; k < kPacks; ++k) {
    const Vec3d a = point_in(random, ball), b = point_in(random, ball);
    float xyz[3][Pack::kLanes];
    for (int lane = 0; lane < Pack::kLanes; ++lane)
      for (int axis = 0; axis < 3; ++axis)
        xyz[axis][lane] = static_cast<float>(a[axis] + (b[axis] - a[axis]) * lane / 8);
    out.push_back({Pack::load(xyz[0]), Pack::load(xyz[1]), Pack::load(xyz[2])});
  }
  return out;
}

struct Batch {
  Values value{}, x{}, y{}, z{};
  bool operator==(const Batch&) const = default;
};

Batch stored(const std::vector<Dual<Pack>>& all) {
  Batch out;
  for (size_t k = 0; k < kPacks; ++k) {
    all[k].v.store(out.value[k].data());
    // Zero has two signs, of which derivatives have either.
    (all[k].dx + Pack(0.0)).store(out.x[k].data());
    (all[k].dy + Pack(0.0)).store(out.y[k].data());
    (all[k].dz + Pack(0.0)).store(out.z[k].data());
  }
  return out;
}

std::vector<Dual<Pack>> gradients(const Field& field, const std::vector<Point<Pack>>& points) {
  Scratch scratch;
  std::vector<Dual<Pack>> out(kPacks);
  field.gradients(points.data(), kPacks, out.data(), scratch);
  return out;
}

Values values(const Field& field, const std::vector<Point<Pack>>& points) {
  Scratch scratch;
  std::vector<Pack> out(kPacks);
  field.values(points.data(), kPacks, out.data(), scratch);
  Values all{};
  for (size_t k = 0; k < kPacks; ++k) out[k].store(all[k].data());
  return all;
}

/// Turned, bent, leaning and flat solids in a cube of 8 m.
std::vector<Field> solids(uint64_t seed, int count) {
  RandomStream random(RandomKey(seed).at("many solids"));
  std::vector<Field> out;
  for (int i = 0; i < count; ++i) {
    const double width = random.uniform(0.02, 0.2), height = random.uniform(0.1, 1.5);
    const Vec3d at = random_point(random, 4);
    if (i % 7 == 0) {
      Drapery drapery;
      drapery.path = {at, at + Vec3d(height, -0.3, 0.2), at + Vec3d(1.5 * height, -0.4, 0.5)};
      drapery.width = 3 * width;
      drapery.finest = 0.05;
      out.push_back(sheet_field("sheet", drapery_sheet(drapery, RandomKey(seed).at("sheet"))));
      continue;
    }
    std::vector<Vec2d> outline{{0, 0}};
    for (int k = 1; k <= 12; ++k)
      outline.emplace_back(width * random.uniform(0.5, 1.0), height * k / 12);
    outline.emplace_back(0, height);
    Field turned = lathe("turned", outline);
    if (i % 3 == 0)
      turned = bent(turned, {BendProfile::foot, Vec3d(0.1 * width, 0, 0.2 * width), 0, height});
    if (i % 5 == 0)
      turned = fluted(turned, {.count = 8, .depth = 0.05 * width, .radius = width},
                      RandomKey(seed).at("flutes"));
    const Vec3d axis = (Vec3d(0, 1, 0) + random_point(random, 0.3)).normalized();
    out.push_back(
        transformed(turned, Transform::translation(at) * rotation_between(Vec3d(0, 1, 0), axis)));
    if (i % 11 == 0) out.push_back(out.back());  // Equal values.
  }
  return out;
}

/// The fold of the operands' own batches, in order.
std::vector<Dual<Pack>> plain_union(const std::vector<Field>& all,
                                    const std::vector<Point<Pack>>& points) {
  std::vector<Dual<Pack>> out = gradients(all[0], points);
  for (size_t i = 1; i < all.size(); ++i) {
    const std::vector<Dual<Pack>> next = gradients(all[i], points);
    for (size_t k = 0; k < kPacks; ++k) out[k] = min(out[k], next[k]);
  }
  return out;
}

TEST(ManySolids, UnionEqualsThePlainMinimum) {
  const std::vector<Field> all = solids(1, 200);
  const Field whole = unite(all);
  RandomStream random(RandomKey(2).at("balls"));
  for (int i = 0; i < 20; ++i) {
    const Ball ball{random_point(random, 4), std::exp2(random.uniform(-4, 2))};
    const std::vector<Point<Pack>> points = rows(random, ball);
    const Batch expected = stored(plain_union(all, points));
    EXPECT_EQ(stored(gradients(whole, points)), expected);
    EXPECT_EQ(values(whole, points), expected.value);
    const Field part = whole.restricted(ball).field;
    EXPECT_EQ(stored(gradients(part, points)).value, expected.value);
    EXPECT_EQ(values(part, points), expected.value);
    for (int k = 0; k < 8; ++k) {
      const Vec3d p = point_in(random, ball);
      Dual<double> least = all[0].node()->eval(seeded(point(p)));
      for (const Field& each : all) least = min(least, each.node()->eval(seeded(point(p))));
      EXPECT_EQ(whole.value(p), least.v);
      EXPECT_EQ(whole.gradient(p).value, least.v);
      EXPECT_EQ(whole.gradient(p).gradient, Vec3d(least.dx, least.dy, least.dz));
    }
  }
}

TEST(ManySolids, RockBlendsWithThemAsWithThePlainMinimum) {
  const std::vector<Field> all = solids(3, 200);
  const Field rock = make("displace", {{"field", as_value(make("half_space"))}, {"amount", 0.2}});
  const Blend blend{Profile::smooth, 0.15};
  const Field whole = unite({rock, unite(all)}, blend);
  RandomStream random(RandomKey(4).at("balls"));
  for (int i = 0; i < 20; ++i) {
    Ball ball{random_point(random, 4), std::exp2(random.uniform(-4, 1))};
    ball.centre.y *= 0.3;
    const std::vector<Point<Pack>> points = rows(random, ball);
    const std::vector<Dual<Pack>> other = plain_union(all, points);
    std::vector<Dual<Pack>> blended = gradients(rock, points);
    for (size_t k = 0; k < kPacks; ++k) blended[k] = blend.smin(blended[k], other[k]);
    const Batch expected = stored(blended);
    EXPECT_EQ(stored(gradients(whole, points)), expected);
    const Field part = whole.restricted(ball).field;
    EXPECT_EQ(values(part, points), expected.value);
    EXPECT_EQ(stored(gradients(part, points)).value, expected.value);
    for (int k = 0; k < 8; ++k) {
      const Vec3d p = point_in(random, ball);
      EXPECT_EQ(part.value(p), whole.value(p));
      EXPECT_EQ(part.value(p), blend.smin(rock.value(p), unite(all).value(p)));
    }
  }
}

/// Knobs on the plane y = 0, where the rock of the next test ends.
std::vector<Nodule> knobs(int count) {
  RandomStream random(RandomKey(8).at("knobs"));
  std::vector<Nodule> out;
  for (int i = 0; i < count; ++i) {
    Vec3d foot = random_point(random, 3);
    foot.y *= 0.03;
    const double radius = random.uniform(0.02, 0.06);
    const Vec3d top = foot + Vec3d(0.03, 2 * radius, 0.02);
    out.push_back({{foot, top, 0.4 * radius, 0.4 * radius}, radius, {Profile::smooth, 0.02}});
  }
  return out;
}

TEST(ManySolids, RockJoinsManySmallElements) {
  const Field rock = make("displace", {{"field", as_value(make("half_space"))}, {"amount", 0.1}});
  for (const Blend& fillet : {Blend{}, Blend{Profile::smooth, 0.05}})
    for (const int count : {300, 4000}) {
      const Field crust = element_field("knobs", knobs(count), Exactness::bound, fillet);
      const Field whole = unite({rock, crust});
      RandomStream random(RandomKey(9).at("balls"));
      for (int i = 0; i < 10; ++i) {
        Ball ball{random_point(random, 3), std::exp2(random.uniform(-4, 1))};
        ball.centre.y *= 0.3;
        const std::vector<Point<Pack>> points = rows(random, ball);
        EXPECT_EQ(stored(gradients(whole, points)), stored(plain_union({rock, crust}, points)));
        const Field::RestrictedField part = whole.restricted(ball);
        const std::vector<Dual<Pack>> parts =
            plain_union({rock.restricted(ball).field, crust.restricted(ball).field}, points);
        const Values found = values(part.field, points), expected = stored(parts).value;
        for (size_t k = 0; k < kPacks; ++k)
          for (size_t lane = 0; lane < Pack::kLanes; ++lane)
            // Lists of elements have single precision, the tree of all has double precision.
            EXPECT_NEAR(found[k][lane], expected[k][lane], 4e-6);
        for (int k = 0; k < 10; ++k) {
          const Vec3d p = point_in(random, ball);
          EXPECT_EQ(part.field.value(p), whole.value(p));
          EXPECT_TRUE(part.range.contains(whole.value(p)));
        }
      }
    }
}

TEST(ManySolids, BoxesExcludeNoSolidThatMatters) {
  const std::vector<Field> all = solids(5, 100);
  BoxLanes boxes;
  for (const Field& solid : all) boxes.add(solid.bounds(), solid.node()->traits().growth_rate(), 5);
  boxes.add(infinite_box(), 0, 0);  // Nothing is known of it.
  RandomStream random(RandomKey(6).at("balls"));
  for (int i = 0; i < 50; ++i) {
    const Ball ball{random_point(random, 4), std::exp2(random.uniform(-4, 1))};
    const std::vector<Point<Pack>> points = rows(random, ball);
    const double limit = random.uniform(-0.1, 1.5);
    const std::vector<Pack> limits(kPacks, Pack(limit));
    std::vector<uint64_t> masks(all.size() + 1);
    boxes.find_candidates(points.data(), limits.data(), BoxLanes::kMostPoints, masks.data());
    std::vector<uint32_t> near;
    boxes.find_candidates(ball, limit, near);
    EXPECT_EQ(masks.back(), ~uint64_t{0});
    EXPECT_EQ(near.back(), all.size());
    EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
    for (size_t s = 0; s < all.size(); ++s) {
      const Values own = values(all[s], points);
      for (size_t k = 0; k < BoxLanes::kMostPoints; ++k) {
        const float least = *std::min_element(own[k].begin(), own[k].end());
        if (least > static_cast<float>(limit)) continue;
        EXPECT_TRUE(masks[s] >> k & 1);
        EXPECT_FALSE(boxes.above(s, points[k], Pack(limit)));
        EXPECT_TRUE(std::binary_search(near.begin(), near.end(), static_cast<uint32_t>(s)));
      }
    }
  }
}

TEST(ManySolids, LayersKeepTheirThicknessInPartsOfSpace) {
  RandomStream random(RandomKey(7).at("layers"));
  std::vector<Deposit> layers;
  for (int i = 0; i < 400; ++i) {
    const Vec3d at = random_point(random, 4);
    layers.push_back(Deposit::along(i, at, at + random_point(random, 0.2), 0.02, 0.03, {}));
  }
  const Field whole = thickness_field(layers);
  int covered = 0;
  for (int i = 0; i < 60; ++i) {
    const Ball ball{random_point(random, 4), std::exp2(random.uniform(-4, 1))};
    const Field::RestrictedField part = whole.restricted(ball);
    const std::vector<Point<Pack>> points = rows(random, ball);
    const std::vector<Dual<Pack>> all = gradients(whole, points);
    EXPECT_EQ(stored(gradients(part.field, points)), stored(all));
    EXPECT_EQ(values(part.field, points), values(whole, points));
    for (int k = 0; k < 20; ++k) {
      const Vec3d p = point_in(random, ball);
      const double value = whole.value(p);
      covered += value > 0;
      EXPECT_EQ(part.field.value(p), value);
      EXPECT_TRUE(part.range.contains(value));
    }
  }
  EXPECT_GT(covered, 50);
}

}  // namespace
}  // namespace vug::field
