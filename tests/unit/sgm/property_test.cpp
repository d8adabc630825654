// SPDX-License-Identifier: Apache-2.0
// Invariants of every derivation, over a thousand seeds with all operations and all sides.
#include "samples.h"

#include <vug/base/parallel.h>
#include <vug/sgm/probe.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace vug::sgm {
namespace {

Rules any_cave(uint64_t seed) {
  Rules rules = figure9();
  rules.classic = 5;
  rules.morphic = 1;
  rules.pieces = 1;
  rules.label = Label::random;
  rules.unite = rules.subtract = rules.intersect = 1;
  if (seed % 2) rules.blend = {field::Profile::smooth, 0.2};
  return rules;
}

void expect_sound(const DerivationResult& cave, uint64_t seed) {
  const double size = size_of(cave.field);
  std::set<int> consumed;
  for (const Placement& p : cave.operations) {
    if (!p.glued) continue;
    EXPECT_TRUE(makes_label(p.base_bond, p.shape_bond, size)) << seed;
    EXPECT_TRUE(on_side(p.base_bond, p.side)) << seed;
    EXPECT_TRUE(consumed.insert(p.base_bond_id).second) << "glued twice, seed " << seed;
    // A cut exposes its wall, which may carry a new bond; joined parts stay joined.
    if (p.operation == Operation::subtract || p.operation == Operation::intersect) continue;
    for (const Bond& free : cave.bonds)  // Neither half of a label is free any more.
      EXPECT_FALSE((free.point - p.base_bond.point).length() < 1e-6 * size &&
                   (free.direction - p.base_bond.direction).length() < 1e-6)
          << seed;
  }
  for (const Bond& free : cave.bonds) {
    EXPECT_NEAR(cave.field.value(free.point), 0, 2e-6 * size) << seed;
    EXPECT_GT(cave.field.value(free.point + free.direction * (1e-3 * size)), -2e-6 * size) << seed;
  }
  EXPECT_TRUE(inner_point(cave.field)) << seed;
}

TEST(Property, LabelsAreMadeAndBondsConsumedOnce) {
  parallel_for(1000, [](size_t seed) {
    const DerivationResult cave = derive(any_cave(seed), RandomKey(seed));
    EXPECT_EQ(cave.counts.total(), 6);
    expect_sound(cave, seed);
  });
}

TEST(Property, AnotherProductionPreservesTheEarlierOnes) {
  for (uint64_t seed = 0; seed < 50; ++seed) {
    Rules rules = any_cave(seed);
    rules.morphic = 0;
    const DerivationResult few = derive(rules, RandomKey(seed));
    rules.classic = 7;
    const DerivationResult more = derive(rules, RandomKey(seed));
    for (size_t i = 0; i < few.operations.size(); ++i) {
      EXPECT_EQ(few.operations[i].map.origin(), more.operations[i].map.origin());
      EXPECT_EQ(few.operations[i].operation, more.operations[i].operation);
    }
  }
}

}  // namespace
}  // namespace vug::sgm
