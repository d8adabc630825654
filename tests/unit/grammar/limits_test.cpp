// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <gtest/gtest.h>

namespace vug::grammar {
namespace {

Grammar bomb() {
  Grammar g;
  g.name = "bomb";
  g.axiom = {part("Room")};
  g.productions = {rule("Room", {part("Room", 2)})};
  g.productions[0].where = {"bomb.vug", 3, 5};
  return g;
}

template <class Action>
Error thrown(const Action& action) {
  try {
    action();
  } catch (const Error& e) {
    return e;
  }
  return Error(ErrorCode::internal, "nothing was thrown");
}

TEST(Limits, ProductionsAreCounted) {
  Limits limits;
  limits.productions = 1000;
  for (const bool parallel : {false, true}) {
    const Error e = thrown([&] {
      parallel ? derive_parallel(bomb(), RandomKey(1), -1, limits)
               : derive(bomb(), RandomKey(1), limits);
    });
    EXPECT_EQ(e.code(), ErrorCode::too_large);
    EXPECT_STREQ(e.what(),
                 "grammar 'bomb' exceeds its limit of 1000 productions while rewriting 'Room'");
    EXPECT_EQ(e.where().line, 3);
  }
}

TEST(Limits, SymbolsAreCounted) {
  Limits limits;
  limits.symbols = 5000;
  const Error e = thrown([&] { derive_parallel(bomb(), RandomKey(1), -1, limits); });
  EXPECT_EQ(e.code(), ErrorCode::too_large);
}

TEST(Limits, HugeCountsAreRejectedBeforeExpansion) {
  Grammar g = bomb();
  g.productions[0].successor = {terminal("x", int64_t{1} << 60)};
  const Error e = thrown([&] { derive(g, RandomKey(1)); });
  EXPECT_EQ(e.code(), ErrorCode::too_large);
  EXPECT_NE(std::string(e.what()).find("'Room' makes 'x'"), std::string::npos);
}

TEST(Limits, ALongChainDoesNotOverflowTheStack) {
  Grammar g;
  g.axiom = {computed("A", [](const RewriteSite&) { return 0.0; })};
  g.productions = {rule("A", {computed("A", [](const RewriteSite& s) { return number(s) + 1; })})};
  g.productions[0].guard = [](const RewriteSite& s) { return number(s) < 200000; };
  EXPECT_EQ(word(derive(g, RandomKey(1))), "A(200000)");
}

TEST(Limits, BadWeightsAndCountsAreNamed) {
  Grammar g = bomb();
  g.productions[0].successor = {terminal("x", -2)};
  EXPECT_STREQ(thrown([&] { derive(g, RandomKey(1)); }).what(), "'x' cannot be repeated -2 times");
  for (const double weight : {-1.0, std::numeric_limits<double>::quiet_NaN(), kInfinity}) {
    g.productions[0].weight = [weight](const RewriteSite&) { return weight; };
    const Error e = thrown([&] { derive(g, RandomKey(1)); });
    EXPECT_EQ(e.code(), ErrorCode::bad_input);
    EXPECT_NE(std::string(e.what()).find("the weight of 'Room -> x'"), std::string::npos);
  }
}

TEST(Limits, ProgressCancels) {
  Progress progress;
  progress.cancel();
  const Error e = thrown([&] { derive(bomb(), RandomKey(1), {}, {}, progress); });
  EXPECT_EQ(e.code(), ErrorCode::cancelled);
}

}  // namespace
}  // namespace vug::grammar
