// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <vug/base/parallel.h>
#include <vug/grammar/tree_output.h>

#include <gtest/gtest.h>

#include <cmath>

namespace vug::grammar {
namespace {

TEST(Derive, RewritesDepthFirstFromTheLeft) {
  Grammar g;
  g.axiom = {part("A", 2), terminal("z")};
  g.productions = {rule("A", {terminal("a"), part("B"), terminal("c")}),
                   rule("B", {terminal("b", 2)})};
  std::string visited;
  const Tree tree = derive(g, RandomKey(1), {}, [&](const Tree& t, int leaf) {
    visited += t.nodes[static_cast<size_t>(leaf)].symbol.name;
  });
  EXPECT_EQ(word(tree), "a b b c a b b c z");
  EXPECT_EQ(visited, "abbcabbcz");
  EXPECT_EQ(tree.applied, 4);
}

TEST(Derive, ParametersReachChildrenAndGuards) {
  // Euclid's algorithm as a grammar, compared with a direct computation.
  Grammar g;
  SuccessorItem start = part("gcd");
  start.content = [](const RewriteSite&) { return Content{{Value(252), Value(105)}, {}, ""}; };
  g.axiom = {start};
  SuccessorItem next = part("gcd");
  next.content = [](const RewriteSite& s) {
    return Content{{Value(number(s, 1)), Value(std::fmod(number(s, 0), number(s, 1)))}, {}, ""};
  };
  Production step = rule("gcd", {next});
  step.arity = 2;
  step.guard = [](const RewriteSite& s) { return number(s, 1) > 0; };
  Production done =
      rule("gcd", {computed("result", [](const RewriteSite& s) { return number(s); })});
  done.guard = [](const RewriteSite& s) { return number(s, 1) == 0; };
  g.productions = {step, done};
  EXPECT_EQ(word(derive(g, RandomKey(1))), "result(21)");
}

TEST(Derive, ArityDistinguishesSymbolsOfOneName) {
  Grammar g;
  g.axiom = {part("A"), computed("A", [](const RewriteSite&) { return 7.0; })};
  g.productions = {rule("A", {terminal("none")}), rule("A", {terminal("one")})};
  g.productions[0].arity = 0;
  g.productions[1].arity = 1;
  EXPECT_EQ(word(derive(g, RandomKey(1))), "none one");
}

TEST(Derive, SymbolsWithoutAnApplicableProductionStayAndAreMarked) {
  Grammar g;
  g.axiom = {part("A")};
  g.productions = {rule("A", {terminal("a")})};
  g.productions[0].guard = [](const RewriteSite&) { return false; };
  const Tree tree = derive(g, RandomKey(1));
  EXPECT_EQ(word(tree), "A");
  EXPECT_TRUE(tree.nodes[1].stuck);
}

TEST(Derive, AnEmptyRightSideErases) {
  Grammar g;
  g.axiom = {part("A"), terminal("b")};
  g.productions = {rule("A", {})};
  EXPECT_EQ(word(derive(g, RandomKey(1))), "b");
}

TEST(Derive, PayloadsAreUnchanged) {
  Grammar g;
  SuccessorItem p = terminal("box");
  p.content = [](const RewriteSite& s) {
    return Content{{}, Vec3d(1, 2, double(s.repetition)), ""};
  };
  p.count = [](const RewriteSite&) { return int64_t{3}; };
  g.axiom = {p};
  const Tree tree = derive(g, RandomKey(1));
  EXPECT_EQ(std::any_cast<Vec3d>(tree.nodes[3].symbol.content.payload), Vec3d(1, 2, 2));
}

TEST(Derive, BothOrdersGiveTheSameTreeOnAnyNumberOfThreads) {
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const std::string serial = tree_text(derive(shrub(), RandomKey(seed)));
    for (const int threads : {1, 2, 5, 8}) {
      with_threads(threads, [&] {
        ASSERT_EQ(serial, tree_text(derive_parallel(shrub(), RandomKey(seed)))) << seed;
      });
    }
  }
}

TEST(Derive, GenerationsStopWhereAsked) {
  Grammar g;
  g.axiom = {part("A")};
  g.productions = {rule("A", {part("A"), part("B")}), rule("B", {part("A")})};
  // Lindenmayer's algae: lengths are Fibonacci numbers.
  const size_t lengths[] = {1, 2, 3, 5, 8, 13, 21, 34, 55};
  for (int n = 0; n < 9; ++n)
    EXPECT_EQ(derive_parallel(g, RandomKey(1), n).leaves().size(), lengths[n]);
}

}  // namespace
}  // namespace vug::grammar
