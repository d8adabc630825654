// SPDX-License-Identifier: Apache-2.0
// Vaults and piles of blocks: beam theory, contact, overlap, slope and bulk.
#include <vug/base/error.h>
#include <vug/base/rng.h>
#include <vug/field/grown_material.h>
#include <vug/field/registry.h>
#include <vug/passages/breakdown/broken_block.h>
#include <vug/passages/breakdown/pile.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::passages {
namespace {

OrientedBox random_box(RandomStream& random) {
  OrientedBox box;
  box.half = {random.uniform(0.2, 1), random.uniform(0.2, 1), random.uniform(0.2, 1)};
  const Vec3d axis(random.normal(), random.normal(), random.normal());
  return box.turned(axis.normalized(), random.uniform(0, 3));
}

TEST(OrientedBox, LandsWhereItFirstTouches) {
  RandomStream random(RandomKey(1));
  int landed = 0;
  for (int i = 0; i < 500; ++i) {
    const OrientedBox below = random_box(random);
    OrientedBox block = random_box(random);
    block.centre = {random.uniform(-1.5, 1.5), 9, random.uniform(-1.5, 1.5)};
    const double height = landing_height(block, below);
    if (height == -kInfinity) {
      for (double y = -3; y < 3; y += 0.1) {
        block.centre.y = y;
        EXPECT_LE(overlap_depth(block, below), 1e-9);
      }
      continue;
    }
    ++landed;
    block.centre.y = height;
    EXPECT_NEAR(overlap_depth(block, below), 0, 1e-9);
    for (double up = 0.01; up < 3; up += 0.1) {
      block.centre.y = height + up;
      EXPECT_LT(overlap_depth(block, below), 0);
    }
    block.centre.y = height - 0.01;
    EXPECT_GT(overlap_depth(block, below), 0);
  }
  EXPECT_GT(landed, 200);
}

// A beam of 0.5 m of limestone (2650 kg/m^3, 5 MPa) bridges 13.9 m, and a ledge has 5.7 m.
TEST(Vault, BedsBridgeTheSpansOfBeams) {
  EXPECT_NEAR(bridged_span(0.5, 5, 2650), 13.9, 0.05);
  EXPECT_NEAR(ledge_length(0.5, 5, 2650), 5.66, 0.05);
  const VaultOptions options{.span = 24, .length = 30, .seed = 3};
  const Vault made = vault(options);
  ASSERT_GT(made.spans.size(), 1u);
  for (size_t i = 0; i < made.spans.size(); ++i) {
    EXPECT_GT(made.spans[i], bridged_span(made.beds[i], options.strength, options.density));
    if (i > 0) {
      EXPECT_LT(made.spans[i], made.spans[i - 1]);
    }
  }
  const field::Field air = vault_body(made);
  for (const OrientedBox& block : made.blocks) {
    EXPECT_LT(air.value(block.centre), 0);
    EXPECT_LT(air.value(block.corner(1, 1, 1)), 0);
  }
  EXPECT_TRUE(vault({.span = 5, .bed = 1, .strength = 10}).blocks.empty());
}

// The strength S / (1 - H) of a bed gives its span the factor (1 - H)^(-1/2).
TEST(Vault, HardBedsBridgeWiderSpans) {
  const auto made_of = [](double hardness) {
    const field::RockMaterialPtr material =
        std::make_shared<field::RockMaterial>(field::RockMaterial{"chert", hardness});
    return field::of_material(field::make("box", {{"size", Vec3d(99, 99, 99)}}), material);
  };
  VaultOptions options{.span = 24, .length = 30, .strength = 2, .seed = 3};
  const Vault bare = vault(options);
  options.rock = made_of(0);
  EXPECT_EQ(vault(options).spans, bare.spans);
  options.rock = made_of(0.5);
  const Vault half = vault(options);
  ASSERT_FALSE(half.spans.empty());
  EXPECT_LT(half.volume(), bare.volume());
  for (size_t i = 0; i < half.spans.size(); ++i)
    EXPECT_GT(half.spans[i], std::sqrt(2) * bridged_span(half.beds[i], 2, options.density));
  options.rock.reset();
  options.strength = 4;
  EXPECT_EQ(vault(options).spans, half.spans);
  options.rock = made_of(1);
  EXPECT_TRUE(vault(options).blocks.empty());
}

/// The slope of the mean height of the tops over the distance from the ridge, fitted where the cone
/// is between 15 and 85 % of its height.
double measured_angle(const Pile& pile, double floor) {
  double n = 0, sx = 0, sy = 0, sxx = 0, sxy = 0;
  const field::Field body = pile_body(pile, floor, 0);
  const double radius = pile.height / pile.slope;
  RandomStream random(RandomKey(9));
  for (int i = 0; i < 6000; ++i) {
    const Vec3d p = pile.foot + Vec3d(random.uniform(-1, 1), 0, random.uniform(-1, 1)) * radius;
    const double cone = pile.cone(p) / pile.height;
    if (cone < 0.15 || cone > 0.85) continue;
    double y = floor + 2 * pile.height;
    while (y > floor && body.value({p.x, y, p.z}) > 0.02)
      y -= std::max(0.02, body.value({p.x, y, p.z}));
    const double x = (1 - cone) * radius, top = std::max(y, floor) - floor;
    n += 1;
    sx += x;
    sy += top;
    sxx += x * x;
    sxy += x * top;
  }
  return -std::atan((n * sxy - sx * sy) / (n * sxx - sx * sx)) * 180 / kPi;
}

TEST(Pile, RestsAtReposeWithItsBulk) {
  for (const uint64_t seed : {1u, 2u, 3u, 4u, 8u}) {
    const Vault above = vault({.at = {3, 14, -2},
                               .span = 16,
                               .length = seed % 2 ? 16.0 : 24.0,
                               .bed = 0.6,
                               .spacing = 1.5,
                               .strength = 1.5,
                               .seed = seed});
    ASSERT_GT(above.blocks.size(), 100u);
    const double floor = -1;
    const Pile made = pile(above, {.floor = floor, .seed = seed});
    const double bulk = made.volume() / above.volume();
    EXPECT_NEAR(bulk, 1.4, 0.07) << seed;
    const double angle = measured_angle(made, floor);
    EXPECT_GT(angle, 30) << seed;
    EXPECT_LE(angle, 36) << seed;
    double solid = 0;
    for (size_t i = 0; i < made.blocks.size(); ++i) {
      const OrientedBox& block = made.blocks[i];
      solid += block.volume();
      double gap = std::fabs(block.centre.y - block.extent({0, 1, 0}) - floor);
      EXPECT_GE(block.centre.y - block.extent({0, 1, 0}), floor - 1e-9);
      for (size_t k = 0; k < made.blocks.size(); ++k) {
        if (k == i) continue;
        const double depth = overlap_depth(block, made.blocks[k]);
        EXPECT_LT(depth, 1e-6) << seed;
        gap = std::min(gap, std::fabs(depth));
      }
      EXPECT_LT(gap, 1e-6) << seed << ": block " << i << " floats";
    }
    EXPECT_GT(solid, 0.6 * above.volume()) << seed;
    EXPECT_LE(solid, above.volume()) << seed;
  }
}

TEST(Pile, IsTheSameForTheSameSeed) {
  const Vault above = vault({.at = {0, 12, 0}, .span = 14, .length = 14, .strength = 1.5});
  const Pile one = pile(above, {}), two = pile(above, {}), other = pile(above, {.seed = 1});
  ASSERT_EQ(one.blocks.size(), two.blocks.size());
  for (size_t i = 0; i < one.blocks.size(); ++i)
    EXPECT_EQ(one.blocks[i].centre, two.blocks[i].centre);
  EXPECT_NE(one.blocks.front().centre, other.blocks.front().centre);
}

/// The value of a convex polytope at a point.
double value_of(const Polytope& part, const Vec3d& p) {
  double out = -kInfinity;
  for (const HalfSpace& face : part.faces) out = std::max(out, face.normal.dot(p) - face.offset);
  return out;
}

// Each block loses a part of its edges and corners, but none of the points at which it rests.
TEST(Pile, BrokenBlocksStillTouch) {
  const Vault above =
      vault({.at = {0, 12, 0}, .span = 14, .length = 14, .spacing = 1.5, .strength = 1.5});
  const Pile made = pile(above, {.broken = 1, .seed = 2}), sharp = pile(above, {.broken = 0});
  ASSERT_EQ(made.broken.size(), made.blocks.size());
  for (const Polytope& part : sharp.broken) EXPECT_EQ(part.faces.size(), 6u);
  const std::vector<std::vector<Vec3d>> contacts = contact_points(made.blocks, 0);
  RandomStream random(RandomKey(4));
  double kept = 0, all = 0;
  std::set<size_t> counts;
  for (size_t i = 0; i < made.blocks.size(); ++i) {
    const OrientedBox& block = made.blocks[i];
    EXPECT_FALSE(contacts[i].empty()) << "block " << i << " floats";
    for (const Vec3d& p : contacts[i]) EXPECT_NEAR(value_of(made.broken[i], p), 0, 1e-4) << i;
    counts.insert(made.broken[i].faces.size());
    for (int k = 0; k < 50; ++k) {
      const Vec3d p =
          block.corner(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      all += block.volume();
      if (value_of(made.broken[i], p) < 0) kept += block.volume();
    }
  }
  EXPECT_GT(counts.size(), 5u) << "blocks differ";
  EXPECT_LT(kept / all, 0.95);
  EXPECT_GT(kept / all, 0.7);
  const Pile again = pile(above, {.broken = 1, .seed = 2});
  for (size_t i = 0; i < made.broken.size(); ++i)
    for (size_t k = 0; k < made.broken[i].faces.size(); ++k)
      EXPECT_EQ(again.broken[i].faces[k].offset, made.broken[i].faces[k].offset);
}

TEST(Breakdown, RefusesBadOptions) {
  const double nan = std::nan("");
  EXPECT_THROW(vault({.span = nan}), Error);
  EXPECT_THROW(vault({.bed = 0}), Error);
  EXPECT_THROW(vault({.bedding = {1, 0, 0}}), Error);
  EXPECT_THROW(vault({.span = 900, .length = 900, .spacing = 0.1, .strength = 0.01}), Error);
  const Vault above = vault({.at = {0, 12, 0}, .strength = 1.5});
  EXPECT_THROW(pile(above, {.floor = 11.5}), Error);
  EXPECT_THROW(pile(above, {.repose = nan}), Error);
  EXPECT_THROW(pile(above, {.bulk = 0}), Error);
  EXPECT_THROW(pile(above, {.broken = nan}), Error);
  EXPECT_THROW(pile(above, {.broken = 1.5}), Error);
  EXPECT_THROW(pile_body({}, 0, 2), Error);
}

}  // namespace
}  // namespace vug::passages
