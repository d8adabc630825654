// SPDX-License-Identifier: Apache-2.0
// Masks on cells: by position once, by attributes in every step.
#include "run.h"

#include <vug/paint/kind.h>

#include <gtest/gtest.h>

namespace vug::cells {
namespace {

Value mask(const std::string& kind, const NamedValues& parameters) {
  return ValueTraits<paint::Mask>::write(make_product(paint::masks(), kind, parameters));
}

paint::Mask as_mask(const Value& value) { return *ValueTraits<paint::Mask>::read(value); }

TEST(Set, FillsFromPlacesAttributesAndNumbers) {
  const NetworkPtr n = uneven();
  const Simulation s =
      ran(n,
          {stage("set", {{"attribute", "one"}, {"to", 3}}),
           stage("set", {{"attribute", "high"}, {"to", mask("height", {{"from", -1}, {"to", 1}})}}),
           stage("set", {{"attribute", "low"},
                         {"to", mask("invert", {{"mask", mask("value", {{"name", "high"}})}})}})},
          1);
  for (uint32_t i = 0; i < n->size(); ++i) {
    const double high = paint::ramp(static_cast<double>(n->position[i].y), -1, 1);
    ASSERT_EQ(s.attributes().values<float>("one")[i], 3);
    ASSERT_FLOAT_EQ(s.attributes().values<float>("high")[i], static_cast<float>(high));
    ASSERT_NEAR(s.attributes().values<float>("low")[i], 1 - high, 1e-6);
  }
}

/// Adds 1.
struct Growing : Rule {
  void step(Pass& pass) const override {
    const auto size = pass.writes<float>("size");
    pass.run([=](const auto&, uint32_t i) { size.set(i, size[i] + 1); });
  }
};

TEST(Masks, ThatUseAttributesAreEvaluatedInEveryStep) {
  const NetworkPtr n = uneven();
  // Each grows while it is below 3, and only then: the probability is 1 or 0.
  Stage growing{std::make_shared<Growing>(), "grow"};
  growing.mask = as_mask(mask("attribute", {{"name", "size"}, {"from", 2.5}, {"to", 2.25}}));
  ASSERT_EQ(growing.mask->uses().size(), 1u);
  Simulation s = ran(n, {growing}, 2);
  for (const float size : s.attributes().values<float>("size")) ASSERT_EQ(size, 2);
  s.run({growing}, 8);
  for (const float size : s.attributes().values<float>("size")) ASSERT_EQ(size, 3);
}

TEST(Masks, ChooseTheSameCellsInEveryStep) {
  const NetworkPtr n = uneven();
  Stage growing{std::make_shared<Growing>(), "grow"};
  growing.mask = as_mask(mask("value", {{"name", "chance"}}));
  growing.draws = RandomKey(5);
  Simulation s(n, RandomKey(1));
  s.attributes().column<float>("chance", 0.25f);
  s.run({growing}, 6);
  double grown = 0;
  for (const float size : s.attributes().values<float>("size")) {
    ASSERT_TRUE(size == 0 || size == 6);
    grown += size == 6;
  }
  const auto cells = static_cast<double>(n->size());
  EXPECT_NEAR(grown / cells, 0.25, 4 * std::sqrt(0.1875 / cells));
  // A mask by position alone selects the cells whose random numbers are below the same probability.
  Stage still{std::make_shared<Growing>(), "grow"};
  still.mask = as_mask(Value(0.25));
  still.draws = RandomKey(5);
  EXPECT_EQ(ran(n, {still}, 6).attributes().values<float>("size"),
            s.attributes().values<float>("size"));
}

TEST(Masks, SeeWhichCellsAreTransparent) {
  const NetworkPtr n = torus(10, 10, 4);
  Simulation s(n, RandomKey(1));
  std::vector<CellState> states(n->size(), CellState::active);
  states[3] = CellState::transparent;
  s.set_states(states);
  const paint::Mask gone = as_mask(mask("value", {{"name", "transparent"}}));
  for (uint32_t i = 0; i < n->size(); ++i) ASSERT_EQ(s.evaluate(gone, i), i == 3 ? 1 : 0);
}

}  // namespace
}  // namespace vug::cells
