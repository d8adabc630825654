// SPDX-License-Identifier: Apache-2.0
#include "parsing.h"

namespace vug::scene {
namespace {

TEST(Expressions, BindAsDocumented) {
  EXPECT_EQ(shape_of("1 + 2 * 3"), "(1 + (2 * 3))");
  EXPECT_EQ(shape_of("a + b & c - d"), "((a + (b & c)) - d)");
  EXPECT_EQ(shape_of("-2 ^ 2"), "(- (2 ^ 2))");
  EXPECT_EQ(shape_of("2 ^ 3 ^ 4"), "(2 ^ (3 ^ 4))");
  EXPECT_EQ(shape_of("2 ^ -1"), "(2 ^ (- 1))");
  EXPECT_EQ(shape_of("8 / 4 / 2"), "((8 / 4) / 2)");
  EXPECT_EQ(shape_of("a or b and not c < d"), "(a or (b and (not (c < d))))");
  EXPECT_EQ(shape_of("1920x1080"), "[1920, 1080]");
  EXPECT_EQ(shape_of("((a))"), "a");
  EXPECT_EQ(shape_of("(1, 2)"), "(1, 2)");
  EXPECT_EQ(shape_of("[1, 2,]"), "[1, 2]");
}

TEST(Expressions, ContinueAcrossUnambiguousLineBreaks) {
  const Document document = parsed("let a = 1 +\n  2\n  * 3\nlet b = f(\n 1,\n\n 2)\n  .g(3)\n");
  EXPECT_EQ(dump(*document.lets[0].value), shape_of("1 + 2 * 3"));
  EXPECT_EQ(dump(*document.lets[1].value), shape_of("f(1, 2).g(3)"));
}

TEST(Expressions, LongSumsAreAcceptedAndDeepOnesRejected) {
  std::string sum = "let a = 1";
  for (int i = 0; i < 900; ++i) sum += " + 1";
  EXPECT_EQ(faults(sum), "");
  for (int i = 0; i < 900; ++i) sum += " + 1";
  EXPECT_EQ(faults(sum), "1: an expression with more than 1000 levels\n");
}

TEST(Expressions, ExcessiveNestingIsRejected) {
  for (const char* bomb : {"(", "[", "-", "f(", "not ", "2^", "a.f("}) {
    std::string text = "let a = ";
    for (int i = 0; i < 100000; ++i) text += bomb;
    EXPECT_NE(faults(text).find("nesting"), std::string::npos) << bomb;
  }
}

TEST(Statements, EveryPartOfADeclaration) {
  const Document document = parsed(
      "seed 7\nparam MP = 52% in 0%..100% \"morph\"\nlet r = 2m\n"
      "cells skin on rock { spacing 2cm  grid triangle\n run a, b,\n c(steps: 40) }\n");
  EXPECT_EQ(document.params[0].doc, "morph");
  EXPECT_EQ(document.params[0].where, (SourceLocation{"t.vug", 2, 7, 2, 9}));
  const Declaration& skin = document.declarations[0];
  EXPECT_EQ(skin.kind, "cells");
  EXPECT_EQ(dump(*skin.target), "rock");
  ASSERT_EQ(skin.entries.size(), 3u);
  EXPECT_EQ(skin.entries[1].key, "grid");
  EXPECT_EQ(skin.entries[2].values.size(), 3u);
  EXPECT_EQ(skin.entries[2].where, (SourceLocation{"t.vug", 5, 2, 5, 5}));
  EXPECT_EQ(document.find("skin"), &skin);
  EXPECT_EQ(document.find("skin", "camera"), nullptr);
}

TEST(Statements, SemicolonsAndBracesOnTheirOwnLines) {
  const Document document =
      parsed("let a = 1; let b = 2\ncamera main\n{\n}\nrender main { spp 1; }");
  EXPECT_EQ(document.lets.size(), 2u);
  EXPECT_EQ(document.declarations.size(), 2u);
}

TEST(Grammars, RulesOfEveryForm) {
  const Document document = parsed(
      "grammar cave {\n  steps 1000; limit 5000\n  axiom Room*10 Melt(2)*1..3\n"
      "  Room @3 -> + sphere(1m) * 4 label +X blend smooth(10cm)\n"
      "  Melt(n) @ 2*n if n > 0\n    -> ~ MP box(1m)\n       - torus(1m).f(2)\n       label -Z\n"
      "       Room Melt(n - 1)\n  Melt(n) -> nothing\n}\n");
  const Grammar& cave = document.grammars.at(0);
  EXPECT_EQ(cave.options.size(), 2u);
  ASSERT_EQ(cave.axiom.size(), 2u);
  EXPECT_EQ(cave.axiom[0].symbol(), "Room");
  EXPECT_EQ(cave.axiom[1].count->kind, ExprKind::range);
  ASSERT_EQ(cave.rules.size(), 3u);
  EXPECT_EQ(cave.rules[0].items[0].clauses.size(), 2u);
  const Rule& melt = cave.rules[1];
  EXPECT_EQ(dump(*melt.weight), "(2 * n)");
  ASSERT_EQ(melt.items.size(), 4u);
  EXPECT_EQ(dump(*melt.items[0].amount), "MP");
  EXPECT_EQ(melt.items[1].op, "-");
  EXPECT_EQ(dump(*melt.items[1].clauses[0].values[0]), "(- Z)");
  EXPECT_EQ(melt.items[3].symbol(), "Melt");
  EXPECT_TRUE(cave.rules[2].items.empty());
}

TEST(Grammars, MorphAmounts) {
  const auto amount = [](const std::string& item) {
    const Document document =
        parsed("grammar g {\n  axiom A\n  A -> " + item + "\n}\nlet rock = 1\n");
    const Item& made = document.grammars.at(0).rules.at(0).items.at(0);
    return (made.amount ? dump(*made.amount) : "-") + " " + dump(*made.shape);
  };
  EXPECT_EQ(amount("~ 52% rock"), "0.52ratio rock");
  EXPECT_EQ(amount("~ MP rock label +X"), "MP rock");
  EXPECT_EQ(amount("~ rock label +X"), "- rock");
  EXPECT_EQ(amount("~ rock"), "- rock");
  EXPECT_EQ(amount("~ rock A"), "- rock");
  EXPECT_EQ(amount("~ (MP / 2) (rock)"), "(MP / 2) rock");
  EXPECT_NE(amount("~ 30%..60% f(1)").find("0.3ratio .."), std::string::npos);
  EXPECT_EQ(amount("~ f(1) label random").substr(0, 3), "- f");
}

TEST(Includes, LoadEachFileOnceAndReportCycles) {
  std::map<std::string, std::string> files = {{"lib/a.vug", "include \"b.vug\"\nlet a = 1"},
                                              {"lib/b.vug", "let b = 2"},
                                              {"data/c.vug", "include \"d.vug\""},
                                              {"data/d.vug", "include \"c.vug\""}};
  ParseOptions options;
  options.include_folders = {"data"};
  options.read = [&](const std::filesystem::path& path) -> std::optional<std::string> {
    const auto found = files.find(path.generic_string());
    return found == files.end() ? std::nullopt : std::optional(found->second);
  };
  Diagnostics diagnostics;
  const Document document = parse("include \"lib/a.vug\"\ninclude \"lib/b.vug\"\nlet c = a + b",
                                  "t.vug", diagnostics, options);
  EXPECT_FALSE(diagnostics.has_errors());
  EXPECT_EQ(document.lets.size(), 3u);
  EXPECT_EQ(document.sources.size(), 3u);
  parse("include \"c.vug\"", "t.vug", diagnostics, options);
  ASSERT_EQ(diagnostics.all().size(), 1u);
  EXPECT_EQ(diagnostics.all()[0].where.file, "data/d.vug");
  EXPECT_EQ(diagnostics.all()[0].hint, "data/c.vug -> data/d.vug -> data/c.vug");
}

TEST(Includes, HugeFilesAreRejected) {
  ParseOptions options;
  options.max_bytes = 100;
  EXPECT_EQ(faults(std::string(101, ' '), options), "1: 't.vug' is larger than 100 bytes\n");
}

}  // namespace
}  // namespace vug::scene
