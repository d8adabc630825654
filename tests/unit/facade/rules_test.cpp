// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

#include <map>

namespace vug::facade {
namespace {

const Rules& ripperda() {
  static const Rules rules = load_rules(VUG_DATA "/facades/ripperda.vug");
  return rules;
}

TEST(Rules, ThePublishedGrammarHas45RulesAnd15Symbols) {
  EXPECT_EQ(ripperda().rules.size(), 45u);
  EXPECT_EQ(ripperda().symbols().size(), 15u);
  std::map<std::string, int> grids;
  for (const Rule& rule : ripperda().rules) {
    EXPECT_TRUE(rule.formals.empty());
    ASSERT_EQ(rule.items.size(), 1u);
    if (rule.items[0].name == "grid") ++grids[rule.head];
  }
  EXPECT_EQ(
      grids,
      (std::map<std::string, int>{
          {"Grid", 2}, {"RegularGrid", 2}, {"IdenticalGrid", 2}, {"RegularIdenticalGrid", 2}}));
  EXPECT_EQ(to_string(ripperda().rules[0]), "Facade -> rows(FacadeRow, PartFacade)");
}

TEST(Rules, ThePublishedGrammarDerives) {
  const std::string text = "include \"ripperda.vug\"\n";
  Diagnostics diagnostics;
  scene::ParseOptions options;
  options.include_folders = {VUG_DATA "/facades"};
  const scene::Document document = scene::parse(text, "t.vug", diagnostics, options);
  scene::Resolver resolver;
  scene::Evaluator evaluator(document, resolver, diagnostics);
  std::map<std::string, int> used;
  for (uint64_t seed = 0; seed < 200; ++seed) {
    const auto made = derive(ripperda(), evaluator, {.key = RandomKey(seed)});
    ASSERT_TRUE(made) << seed;
    for (const ElementInstance& one : element_instances(made->tree)) {
      const Rect& r = one.rect;
      EXPECT_TRUE(r.x >= -1e-9 && r.right() <= 12 + 1e-9 && r.width > 0);
      EXPECT_TRUE(r.y >= -1e-9 && r.top() <= 9 + 1e-9 && r.height > 0);
    }
    for (const Node& node : made->tree.nodes) ++used[node.rule];
  }
  EXPECT_EQ(diagnostics.all().size(), 0u);
  for (const Rule& rule : ripperda().rules) EXPECT_GT(used[to_string(rule)], 0) << to_string(rule);
}

TEST(Rules, UnknownNamesAreFoundWithoutDeriving) {
  const Sample s = facade_of("axiom A\n A -> rows(1, Bse, 1, wall)\n Base -> wndow");
  EXPECT_NE(
      s.said.find("'Bse' is neither a symbol with a rule nor a split nor an element (did you mean "
                  "'Base'?)"),
      std::string::npos)
      << s.said;
  EXPECT_NE(s.said.find("(did you mean 'window'?)"), std::string::npos) << s.said;
  EXPECT_EQ(s.where.line, 4);
  EXPECT_EQ(s.where.column, 10);
  EXPECT_NE(facade_of("axiom A\n A -> B(1)\n B -> wall").said.find("'B' has 1 argument"),
            std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> rows").said.find("'rows' has no parts"), std::string::npos);
  EXPECT_NE(facade_of("axiom A\n A -> + sphere(1m)").said.find("expected a symbol, a split"),
            std::string::npos);
}

}  // namespace
}  // namespace vug::facade
