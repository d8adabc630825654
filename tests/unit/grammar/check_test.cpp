// SPDX-License-Identifier: Apache-2.0
#include "samples.h"

#include <gtest/gtest.h>

namespace vug::grammar {
namespace {

TEST(Check, AcceptsWhatDerives) {
  Diagnostics diagnostics;
  check(shrub(), diagnostics);
  EXPECT_TRUE(diagnostics.all().empty());
}

TEST(Check, NamesUnknownSymbolsWithTheNearest) {
  Grammar g;
  g.axiom = {part("Rom")};
  g.axiom[0].where = {"a.vug", 2, 9};
  g.productions = {rule("Room", {terminal("x")})};
  Diagnostics diagnostics;
  check(g, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 2u);
  EXPECT_EQ(diagnostics.all()[0].message, "no production rewrites 'Rom'");
  EXPECT_EQ(diagnostics.all()[0].hint, "did you mean 'Room'?");
  EXPECT_EQ(diagnostics.all()[0].where.column, 9);
  EXPECT_EQ(diagnostics.all()[1].severity, Severity::warning);
  EXPECT_EQ(diagnostics.all()[1].message, "the production 'Room -> x' is unreachable");
}

TEST(Check, RequiresAnAxiom) {
  Grammar g;
  g.name = "cave";
  Diagnostics diagnostics;
  check(g, diagnostics);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].message, "grammar 'cave' has no axiom");
}

}  // namespace
}  // namespace vug::grammar
