// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/field/material_source.h>
#include <vug/field/registry.h>
#include <vug/field/rock_material_kind.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace vug::sgm {
namespace {

Geology strata() {
  return {{{"shale", moved(box({100, 1, 100}), {0, 1, 0}), 0.1, 0.2},
           {"limestone", solid(TestHalfSpace{{0, 1, 0}}), 0.5, 1.0}}};
}

TEST(Geology, MapsTheAmountToTheRangeOfTheRock) {
  const Geology g = strata();
  EXPECT_DOUBLE_EQ(g.amount_at({0, 1, 0}, 0.5), 0.15);
  EXPECT_DOUBLE_EQ(g.amount_at({0, -3, 0}, 0.5), 0.75);
  EXPECT_DOUBLE_EQ(g.amount_at({0, -3, 0}, 0), 0.5);
  EXPECT_DOUBLE_EQ(g.amount_at({0, -3, 0}, 1), 1);
  EXPECT_DOUBLE_EQ(g.amount_at({0, 9, 0}, 0.5), 0.5);  // between the components
  EXPECT_EQ(g.at({0, 1, 0})->name, "shale");
  EXPECT_EQ(g.at({0, 9, 0}), nullptr);
}

TEST(Geology, DecidesWhatAMorphDoes) {
  Options options;
  options.geology = strata();
  for (const double height : {1.0, -5.0}) {
    Growth growth(options);
    growth.apply(step(Operation::unite, moved(ball(1), {0, height, 0})), RandomKey(1));
    ProductionStep melt = step(Operation::morph, ball(1));
    melt.amount = 0.52;
    const Placement& done = growth.apply(melt, RandomKey(2));
    EXPECT_DOUBLE_EQ(done.amount, height > 0 ? 0.1 + 0.1 * 0.52 : 0.5 + 0.5 * 0.52);
  }
}

/// Soft rock, and rock of hardness 0.75 in the body, with a contact of 10 cm.
Field two_rocks(const Field& body) {
  const Value hard =
      Object{"rock material", field::RockMaterialPtr(std::make_shared<field::RockMaterial>(
                                  field::RockMaterial{"hard", 0.75}))};
  return field::make(
      "host_rock",
      {{"field", field::as_value(box({100, 100, 100}))},
       {"of", "soft"},
       {"bodies", List{field::as_value(
                      field::make("made_of", {{"field", field::as_value(body)}, {"of", hard}}))}}});
}

TEST(Geology, HardRockLimitsTheAmount) {
  Geology g;
  g.rock = two_rocks(solid(TestHalfSpace{{0, -1, 0}}));
  EXPECT_EQ(g.amount_at({0, -3, 0}, 0.6), 0.6);
  EXPECT_DOUBLE_EQ(g.amount_at({0, 3, 0}, 0.6), 0.15);
  EXPECT_NEAR(g.amount_at({0, 0, 0}, 0.6), 0.6 * (1 - 0.375), 1e-9);
  g.components = strata().components;
  EXPECT_DOUBLE_EQ(g.amount_at({0, 1, 0}, 0.5), 0.25 * 0.15);
}

// Figure 9 in two rocks: the first morph is in the soft rock and stays, the second one is in the
// hard rock. The caves differ only there, and at the shapes that are glued to it later.
TEST(Geology, Figure9DiffersOnlyWhereItsMorphsLieInTheSecondRock) {
  const grammar::Grammar grammar = grammar_of(figure9());
  int compared = 0;
  for (uint64_t seed = 1; seed <= 6; ++seed) {
    const DerivationResult soft = derive(grammar, RandomKey(seed), Options());
    std::vector<size_t> morphs;
    for (size_t i = 0; i < soft.operations.size(); ++i)
      if (soft.operations[i].operation == Operation::morph && soft.operations[i].glued)
        morphs.push_back(i);
    ASSERT_LE(morphs.size(), 2u);
    if (morphs.size() < 2) continue;
    const Vec3d first = soft.operations[morphs[0]].base_bond.point,
                second = soft.operations[morphs[1]].base_bond.point;
    if (second.x < first.x + 1) continue;
    ++compared;
    Options options;
    options.geology.rock =
        two_rocks(solid(TestHalfSpace{{-1, 0, 0}, {0.5 * (first.x + second.x), 0, 0}}));
    const DerivationResult both = derive(grammar, RandomKey(seed), options);
    ASSERT_EQ(both.operations.size(), soft.operations.size());
    EXPECT_EQ(both.operations[morphs[0]].amount, 0.52);
    EXPECT_NEAR(both.operations[morphs[1]].amount, 0.25 * 0.52, 1e-12);
    std::vector<Box3d> changed;
    for (size_t i = morphs[1]; i < soft.operations.size(); ++i)
      for (const DerivationResult* each : {&soft, &both})
        changed.push_back(grown(each->operations[i].field.bounds(), 0.3));
    const Box3d box = grown(soft.field.bounds(), 0.2);
    RandomStream random(RandomKey(seed).at("points"));
    double most = 0;
    for (int i = 0; i < 20000; ++i) {
      const double x = random.uniform(box.min.x, box.max.x);
      const double y = random.uniform(box.min.y, box.max.y);
      const Vec3d p(x, y, random.uniform(box.min.z, box.max.z));
      const double a = soft.field.value(p), b = both.field.value(p);
      if (std::none_of(changed.begin(), changed.end(),
                       [&](const Box3d& each) { return each.intersects(p); })) {
        ASSERT_EQ(a < 0, b < 0) << p;
      }
      most = std::max(most, std::fabs(a - b));
    }
    EXPECT_GT(most, 0.05) << seed;
  }
  EXPECT_GE(compared, 2);
}

// The local morph adds half of the shape's material where the shape is nearer.
TEST(Geology, TheShapesOfACaveKeepTheirMaterials) {
  const auto of = [](const Field& field, const char* name) {
    return field::make("made_of", {{"field", field::as_value(field)}, {"of", name}});
  };
  Growth growth{Options()};
  growth.apply(step(Operation::unite, of(ball(1), "limestone")), RandomKey(1));
  ProductionStep melt = step(Operation::morph, of(box({0.5, 0.5, 0.5}), "calcite"));
  melt.amount = 0.5;
  growth.apply(melt, RandomKey(2));
  const Field cave = with_places(growth.field(), {{"hall", {}}});
  std::vector<std::string> names;
  for (const field::RockMaterialPtr& each : field::materials_of(cave)) names.push_back(each->name);
  EXPECT_EQ(names, (std::vector<std::string>{"calcite", "limestone"}));
  const field::MaterialSample ahead = field::sample_materials(*cave.node(), {5, 0, 0}),
                              behind = field::sample_materials(*cave.node(), {-5, 0, 0});
  EXPECT_NEAR(ahead.value, cave.value({5, 0, 0}), 1e-12);
  EXPECT_DOUBLE_EQ(ahead.mix.weight("calcite"), 0.5);
  EXPECT_EQ(behind.mix.weight("limestone"), 1);
}

TEST(Geology, RefusesInvalidRanges) {
  Options options;
  options.geology.components = {{"marl", Field(), 0.7, 0.2}};
  EXPECT_THROW(Growth{options}, Error);
  options.geology.components = {{"marl", Field(), -0.1, 0.2}};
  EXPECT_THROW(Growth{options}, Error);
}

}  // namespace
}  // namespace vug::sgm
