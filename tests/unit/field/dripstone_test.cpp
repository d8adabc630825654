// SPDX-License-Identifier: Apache-2.0
// Dripstone follows water: vertical, attached, inside its box, and only below drips.
#include <vug/base/parallel.h>
#include <vug/base/rng.h>
#include <vug/field/boolean.h>
#include <vug/field/dripstone.h>
#include <vug/field/registry.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::field {
namespace {

/// Rock with a hall 6 m wide and 3 m high whose roof has a slope of about 11 degrees.
Field hall() {
  const Field box = make("box", {{"size", Vec3d(6, 4, 6)}});
  const Field roof = make("half_space", {{"normal", Vec3d(0.2, 1, 0)}, {"offset", 1.0}});
  return complement(intersect({box, roof}));
}
DripOptions options() {
  DripOptions o;
  o.from = Vec3d(-3, -3, -3);
  o.to = Vec3d(3, 3, 3);
  o.spacing = 0.5;
  o.length = 1;
  return o;
}
Noise everywhere(double value) {
  // A distant half-space has nearly the same value everywhere within the size of the box.
  Field far = make("half_space", {{"offset", -value * 1e6}});
  return {std::move(far), {-2e6, 2e6}};
}

TEST(Dripstone, DripsFallVerticallyFromRoofsToFloors) {
  const Field rock = hall();
  const auto drips = find_drips(rock, options());
  ASSERT_GT(drips.size(), 40u);  // Half of 144 places.
  ASSERT_LT(drips.size(), 104u);
  for (const Drip& d : drips) {
    EXPECT_EQ(d.roof.x, d.floor.x);
    EXPECT_EQ(d.roof.z, d.floor.z);
    EXPECT_NEAR(rock.value(d.roof), 0, 1e-6);
    EXPECT_NEAR(rock.value(d.floor), 0, 1e-6);
    EXPECT_NEAR(d.floor.y, -2, 1e-6);
    EXPECT_GT(d.stalactite, 0);
    EXPECT_LE(d.stalactite, 1.0);
    EXPECT_LT(d.stalactite, d.roof.y - d.floor.y);
  }
}

TEST(Dripstone, GrowsFromTheRockAndHangsInTheAir) {
  const Field rock = hall();
  const DripOptions o = options();
  for (const Drip& d : find_drips(rock, o)) {
    const Field alone = dripstone({d}, o);
    EXPECT_LT(alone.value(d.roof), 0) << "it hangs from the roof";
    const Vec3d middle = d.roof - Vec3d(0, 0.5 * d.stalactite, 0);
    EXPECT_LT(alone.value(middle), 0) << "it is not broken";
    if (d.column) {
      for (double t = 0.05; t < 1; t += 0.05) {
        EXPECT_LT(alone.value(d.floor + (d.roof - d.floor) * t), 0);
      }
      continue;
    }
    EXPECT_GT(alone.value(d.roof - Vec3d(0, d.stalactite + 2 * o.tip, 0)), 0) << "it ends";
    const double thick = std::max(o.girth * d.stalactite, 1.2 * o.tip);
    EXPECT_GT(alone.value(middle + Vec3d(thick, 0, 0)), 0) << "it is thinner below";
  }
}

TEST(Dripstone, TheMaskSelectsAllOrNone) {
  DripOptions o = options();
  o.where = everywhere(-1);
  EXPECT_TRUE(find_drips(hall(), o).empty());
  o.where = everywhere(1);
  EXPECT_GE(find_drips(hall(), o).size(), 130u);  // 144 places, some too close to a wall.
}

TEST(Dripstone, PlacesAreTheSameForEveryCompiler) {
  // Each cell of the plan draws z before x; the evaluation order of arguments is unspecified in
  // C++.
  DripOptions o = options();
  o.where = everywhere(1);
  const RandomKey key = RandomKey(static_cast<uint64_t>(o.seed)).at("dripstone");
  for (const Drip& d : find_drips(hall(), o)) {
    const double column = std::floor((d.roof.x - o.from.x) / o.spacing);
    const double row = std::floor((d.roof.z - o.from.z) / o.spacing);
    RandomStream random(key.at(static_cast<uint64_t>(column)).at(static_cast<uint64_t>(row)));
    EXPECT_EQ(d.roof.z, o.from.z + o.spacing * (row + random.uniform()));
    EXPECT_EQ(d.roof.x, o.from.x + o.spacing * (column + random.uniform()));
  }
}

TEST(Dripstone, NoDripsWithoutARoof) {
  EXPECT_TRUE(find_drips(empty(), options()).empty());
  EXPECT_TRUE(find_drips(complement(empty()), options()).empty());
  const Field steep = complement(make("cone", {{"radius", 0.5}, {"height", 6.0}}));
  EXPECT_TRUE(find_drips(steep, options()).empty()) << "water runs down a steep wall";
}

TEST(Dripstone, StalagmitesAreAFraction) {
  DripOptions o = options();
  o.spacing = 0.2;
  for (const double share : {0.0, 0.5, 1.0}) {
    o.stalagmites = share;
    const auto drips = find_drips(hall(), o);
    double with = 0;
    for (const Drip& d : drips) with += d.stalagmite > 0 ? 1 : 0;
    const auto n = static_cast<double>(drips.size());
    EXPECT_NEAR(with / n, share, 4 * std::sqrt(share * (1 - share) / n) + 1e-9);
  }
}

TEST(Dripstone, AnyGirthAndTipGiveASolid) {
  for (const double girth : {0.01, 0.12, 0.5})
    for (const double tip : {0.002, 0.03, 0.3})
      for (const double length : {0.05, 1.0, 20.0}) {
        DripOptions o = options();
        o.girth = girth, o.tip = tip, o.length = length, o.stalagmites = 1;
        Field grown;
        EXPECT_NO_THROW(grown = dripstone(find_drips(hall(), o), o))
            << girth << " " << tip << " " << length;
        const Box3d bounds = dripstone_bounds(hall().bounds(), o);
        EXPECT_TRUE(bounds.intersects(grown.bounds().min) && bounds.intersects(grown.bounds().max))
            << girth << " " << tip << " " << length;
      }
}

TEST(Dripstone, SameForAnyNumberOfThreads) {
  const auto drips_with = [](int threads) {
    return with_threads(threads, [&] { return find_drips(hall(), options()); });
  };
  const auto one = drips_with(1), many = drips_with(7);
  ASSERT_EQ(one.size(), many.size());
  for (size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].roof, many[i].roof);
    EXPECT_EQ(one[i].stalactite, many[i].stalactite);
  }
}

TEST(Dripstone, TheKindIncludesTheRock) {
  const Field rock = hall();
  const Field grown = make("dripstone", {{"field", as_value(rock)},
                                         {"from", Vec3d(-3, -3, -3)},
                                         {"to", Vec3d(3, 3, 3)},
                                         {"spacing", 0.5}});
  double added = 0;
  for (double x = -2.9; x < 3; x += 0.1)
    for (double y = -2.4; y < 2; y += 0.1) {
      const Vec3d p(x, y, 0.35);
      EXPECT_LE(grown.value(p), rock.value(p) + 1e-12);
      if (grown.value(p) < 0 && rock.value(p) > 0) added += 1;
    }
  EXPECT_GT(added, 20);
  EXPECT_THROW(
      make("dripstone",
           {{"field", as_value(rock)}, {"from", Vec3d(1, 1, 1)}, {"to", Vec3d(-1, -1, -1)}}),
      Error);
}

}  // namespace
}  // namespace vug::field
