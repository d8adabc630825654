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
  for (const char* clause :
       {"overlap 10%", "reach whole", "pieces 2", "piece_label +X", "slope -5deg", "azimuth [5deg]",
        "within lot", "apart 2m", "name \"hall\"", "connect [\"a\", \"b\"]"})
    EXPECT_EQ(amount(std::string("~ rock ") + clause), "- rock") << clause;
  EXPECT_EQ(amount("~ MP name label +X"), "MP name");
  EXPECT_EQ(amount("~ MP apart name \"hall\""), "MP apart");
  EXPECT_EQ(amount("~ MP slope(2m)").substr(0, 8), "MP slope");
  EXPECT_EQ(amount("~ (MP / 2) (rock)"), "(MP / 2) rock");
  EXPECT_NE(amount("~ 30%..60% f(1)").find("0.3ratio .."), std::string::npos);
  EXPECT_EQ(amount("~ f(1) label random").substr(0, 3), "- f");
}

TEST(ByRock, IsATableOfMaterials) {
  const auto without_paths = [](std::string text) {
    for (size_t at = text.find('#'); at != std::string::npos; at = text.find('#'))
      text.erase(at, text.find('(', at) - at);
    return text;
  };
  const std::string expected = without_paths(
      shape_of("by_rock(of: [\"limestone\", \"clay 2\"], materials: [grey, f(1)], otherwise: g)"));
  EXPECT_EQ(
      without_paths(shape_of("by rock { limestone -> grey, \"clay 2\" -> f(1), otherwise -> g }")),
      expected);
  EXPECT_EQ(without_paths(shape_of("by rock {\n  limestone -> grey\n  \"clay 2\" ->\n    f(1)\n"
                                   "  otherwise -> g,\n}")),
            expected);
  // Both words remain names.
  EXPECT_EQ(shape_of("by"), "by");
  EXPECT_EQ(shape_of("rock + by"), "(rock + by)");
  const Document document =
      parsed("let a = 1\nobject o on rock { material by rock { x -> a }  flat true }");
  ASSERT_EQ(document.declarations.size(), 1u);
  ASSERT_EQ(document.declarations[0].entries.size(), 2u);
  const Expr& call = *document.declarations[0].entries[0].values.at(0);
  const Operand& rock = call.operands.at(0).value->operands.at(0);
  EXPECT_EQ(rock.value->where.line, 2);
  EXPECT_EQ(rock.value->where.column, 39);
}

TEST(ByRock, RandomDrawsOfAMaterialDependOnItsRock) {
  const auto path = [](const std::string& text) {
    const std::string shape = shape_of(text);
    const size_t at = shape.find("f#");
    return shape.substr(at, shape.find('(', at) - at);
  };
  const std::string alone = path("by rock { clay -> f(1) }");
  EXPECT_EQ(path("by rock { sand -> g, clay -> f(1) }"), alone);
  EXPECT_NE(path("by rock { sand -> f(1) }"), alone);
}

TEST(ByRock, FaultsNameTheProblem) {
  EXPECT_EQ(faults("let a = by rock {}"), "1: 'by rock' without a rock\n");
  EXPECT_EQ(faults("let a = by rock { otherwise -> b }"),
            "1: 'by rock' has only the row 'otherwise'\n");
  EXPECT_EQ(faults("let a = by rock {\n x -> b\n x -> c\n}"),
            "3: a second material for the rock 'x'\n");
  EXPECT_EQ(faults("let a = by rock { x -> b, otherwise -> c, otherwise -> d }"),
            "1: a second 'otherwise'\n");
  EXPECT_EQ(faults("let a = by rock { x = b }"),
            "1: expected '->' and a material after the rock x, found '='\n");
  EXPECT_NE(
      faults("let a = by rock {\n x -> b\n").find("expected a rock or '}' to close '{' of line 1"),
      std::string::npos);
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
