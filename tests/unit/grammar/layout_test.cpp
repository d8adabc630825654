// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/grammar/layout.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace vug::grammar {
namespace {

TEST(Layout, PlacesAParentInTheMiddle) {
  Grammar g;
  g.axiom = {terminal("a", 4)};
  const std::vector<double> place = tidy_layout(derive(g, RandomKey(1)));
  EXPECT_EQ(place, (std::vector<double>{1.5, 0, 1, 2, 3}));
}

TEST(Layout, KeepsNeighboursApartAndEqualSubtreesEqual) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const Tree tree = derive(shrub(), RandomKey(seed));
    const std::vector<double> place = tidy_layout(tree);
    std::map<int, double> last;  // by depth; depth-first order visits a level from low to high
    for (size_t i = 0; i < tree.nodes.size(); ++i) {
      ASSERT_GE(place[i], 0);
      const auto [it, fresh] = last.try_emplace(tree.nodes[i].depth, place[i]);
      if (!fresh) {
        ASSERT_GE(place[i] - it->second, 1 - 1e-9) << "seed " << seed << " node " << i;
      }
      it->second = place[i];
    }
  }
}

TEST(Layout, SubtreesNestWhereTheirContoursLetThem) {
  // A deep narrow child next to a shallow wide one: the leaves of the wide one need not clear the
  // lower levels of the deep one, so the drawing is only as wide as its widest level.
  Grammar g;
  g.axiom = {part("Deep"), part("Wide")};
  g.productions = {rule("Deep", {part("Deeper")}), rule("Deeper", {terminal("x", 3)}),
                   rule("Wide", {terminal("y", 2)})};
  const Tree tree = derive(g, RandomKey(1));
  const std::vector<double> place = tidy_layout(tree);
  EXPECT_DOUBLE_EQ(*std::max_element(place.begin(), place.end()), 3);
}

TEST(Layout, HandlesALongChain) {
  Grammar g;
  g.axiom = {computed("A", [](const RewriteSite&) { return 0.0; })};
  g.productions = {rule("A", {computed("A", [](const RewriteSite& s) { return number(s) + 1; })})};
  g.productions[0].guard = [](const RewriteSite& s) { return number(s) < 100000; };
  for (const double place : tidy_layout(derive(g, RandomKey(1)))) ASSERT_EQ(place, 0);
}

}  // namespace
}  // namespace vug::grammar
