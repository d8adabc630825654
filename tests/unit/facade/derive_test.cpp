// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

namespace vug::facade {
namespace {

TEST(Derive, GuardsAndWeightsUseTheScope) {
  const std::string rules =
      "axiom A\n A -> rows(3m, Storey, 1, Storey)\n"
      "Storey if height > 4m -> repeat(x, 4m, window)\n"
      "Storey if height <= 4m and width == 12m -> columns(width / 4, door, 1, shop)";
  const Sample s = facade_of(rules);
  ASSERT_EQ(s.said, "");
  EXPECT_EQ(s.rects("window").size(), 3u);
  expect_rect(s.rects("door")[0], 0, 0, 3, 3);
}

TEST(Derive, IndexAndTotalOfACell) {
  const Sample s = facade_of(
      "axiom A\n A -> repeat(x, Bay, count: 5, alike: false)\n"
      "Bay if index == 2 and total == 5 -> door\n Bay if index != 2 -> window");
  EXPECT_EQ(s.rects("window").size(), 4u);
  expect_rect(s.rects("door")[0], 4.8, 0, 2.4, 9);
}

TEST(Derive, ParametersIncludingElements) {
  const Sample s = facade_of(
      "axiom A\n A -> rows(1, Bays(2), 1, Bays(3))\n"
      "Bays(n) -> repeat(x, Bay(n > 2), count: n)\n"
      "Bay(door_too) if door_too -> door\n Bay(door_too) if not door_too -> window");
  ASSERT_EQ(s.said, "");
  EXPECT_EQ(s.rects("window").size(), 2u);
  EXPECT_EQ(s.rects("door").size(), 3u);
  EXPECT_EQ(s.tree.nodes[1].text, "Bays(2)");
}

TEST(Derive, ArgumentsUseTheCellOfTheirPart) {
  const Sample s = facade_of(
      "axiom A\n A -> repeat(x, P, Bay(index, width), alike: false)\n"
      "Bay(i, w) if i == 1 -> columns(w / 4, door, 1, wall)\n Bay(i, w) if i != 1 -> wall");
  EXPECT_NE(s.said.find("'P' is neither a symbol"), std::string::npos);
  const Sample t = Sample(
      "let P = 4m\ngrammar f: facade {\naxiom A\n A -> repeat(x, P, Bay(index, width), alike: "
      "false)\nBay(i, w) if i == 1 -> columns(w / 4, door, 1, wall)\n Bay(i, w) if i != 1 -> "
      "wall\n}");
  EXPECT_EQ(t.said, "");
  expect_rect(t.rects("door")[0], 4, 0, 1, 9);
}

TEST(Derive, SeveralItemsShareTheScope) {
  const Sample s = facade_of("axiom A\n A -> wall columns(1m, window, 1, wall) door");
  EXPECT_EQ(s.rects("wall").size(), 2u);
  expect_rect(s.rects("door")[0], 0, 0, 12, 9);
}

TEST(Derive, InfiniteRecursionIsStopped) {
  EXPECT_THROW(facade_of("axiom A\n A -> B\n B -> A"), Error);
  try {
    facade_of("axiom A\n A -> columns(1, A, 1, A)");
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_EQ(error.where().line, 3);
  }
}

TEST(Derive, SymbolsWithoutAnApplicableRuleAreWarnings) {
  const Sample s = facade_of("axiom A\n A -> columns(1, B, 3, B)\n B if width > 5m -> wall");
  EXPECT_EQ(s.said,
            "no rule of 'B' applies to 3 x 9 m (add a rule without a guard for all other "
            "cases)\n");
  EXPECT_EQ(s.rects("wall").size(), 1u);
}

TEST(Derive, EqualSeedsGiveEqualTrees) {
  const std::string rules =
      "axiom A\n A -> rows(B, B)\n B @2 -> mirror(C, B)\n B -> grid(window)\n C -> grid(window, "
      "door)";
  EXPECT_EQ(theta(facade_of(rules, 5).tree), theta(facade_of(rules, 5).tree));
  EXPECT_NE(theta(facade_of(rules, 5).tree), theta(facade_of(rules, 6).tree));
  // The random numbers of a part do not depend on its neighbours.
  const Sample a = facade_of("axiom A\n A -> rows(4m, B, 1, wall)\n B -> grid(window)");
  const Sample b = facade_of("axiom A\n A -> rows(4m, B, 1, door, 1, wall)\n B -> grid(window)");
  EXPECT_EQ(a.rects("window"), b.rects("window"));
}

}  // namespace
}  // namespace vug::facade
