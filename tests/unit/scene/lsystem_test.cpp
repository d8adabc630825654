// SPDX-License-Identifier: Apache-2.0
// The dialect of L-systems: parsing, errors with their locations, and formatting.
#include <gtest/gtest.h>
#include <vug/scene/format.h>
#include <vug/scene/lsystem_document.h>
#include <vug/scene/module_names.h>
#include <vug/scene/report.h>

#include "parsing.h"

namespace vug::scene {
namespace {

struct Read {
  Document document;
  Diagnostics diagnostics;
  std::string report;
};

Read read(const std::string& text) {
  Read out;
  out.document = parse(text, "t.vug", out.diagnostics);
  out.report = report(out.diagnostics, out.document.sources);
  return out;
}

std::string names(const ModuleString& word) {
  std::string out;
  for (const Module& module : word)
    out += (out.empty() ? "" : " ") + module.name +
           (module.arguments.empty() ? "" : std::to_string(module.arguments.size()));
  return out;
}

TEST(LSystemText, SplitsNamesAtCapitals) {
  const auto split = [](std::string_view letters) {
    std::string out;
    for (const std::string_view name : split_names(letters)) out += std::string(name) + ' ';
    return out;
  };
  EXPECT_EQ(split("FFA"), "F F A ");
  EXPECT_EQ(split("FlFlFr"), "Fl Fl Fr ");
  EXPECT_EQ(split("LeafBud2"), "Leaf Bud2 ");
  EXPECT_EQ(split("Fff"), "F f f ");
  EXPECT_EQ(split("f"), "f ");
  EXPECT_EQ(split("ffffff"), "f f f f f f ");
  EXPECT_EQ(split("ffl"), "ffl ");
  EXPECT_EQ(split("leaf"), "leaf ");
  EXPECT_EQ(split("fF"), "f F ");
  EXPECT_EQ(split("Leaff"), "Leaff ");
}

TEST(LSystemText, ReadsWordsOfThePublication) {
  const Read plant = read(R"(grammar tree: lsystem {
  steps 7; angle 22.5deg
  axiom A   # prusinkiewicz1990, figure 1.25
  A -> [&FL!A]/////'[&FL!A]///////'[&FL!A]
  F -> S ///// F
  S -> F L
  L -> ['''^^{-f+f+f-|-f+f+f}]
  X -> [+A{.].C.}..
  Y -> F \ | $ % ?P(0, 0, 0)
      [+F(1)]
      F
  Z -> nothing
}
)");
  EXPECT_EQ(plant.report, "");
  const LSystem& system = *plant.document.grammars.at(0).lsystem;
  EXPECT_EQ(plant.document.grammars[0].options.size(), 2u);
  EXPECT_EQ(names(system.axiom), "A");
  ASSERT_EQ(system.productions.size(), 7u);
  EXPECT_EQ(names(system.productions[3].word), "[ ' ' ' ^ ^ { - f + f + f - | - f + f + f } ]");
  EXPECT_EQ(names(system.productions[4].word), "[ + A { . ] . C . } . .");
  EXPECT_EQ(names(system.productions[5].word), "F \\ | $ % ?P3 [ + F1 ] F");
  EXPECT_EQ(names(system.productions[6].word), "");
  EXPECT_EQ(system.productions[0].word[2].where.column, 10);  // F of [&FL!A]
}

TEST(LSystemText, ReadsHeads) {
  const Read heads = read(R"(grammar g: lsystem {
  axiom A(1)
  ignore + - F
  ages L(a)
  B(x) C < A(y) > [D] E(z) @0.5 if x > y -> A(y + 1)
  + -> -
  A(t) after 2 * t
    -> B
  table one { A > B -> C; B -> A }
  decompose {
    depth 3
    A -> B
  }
  interpret { A -> F }
  schedule one*3, one
}
)");
  EXPECT_EQ(heads.report,
            "t.vug:4:8: error: 'ages' can only list names\n  ages L(a)\n       ^~~~\n");
  const LSystem& system = *heads.document.grammars.at(0).lsystem;
  ASSERT_EQ(system.productions.size(), 3u);
  const Production& first = system.productions[0];
  EXPECT_EQ(first.left.size(), 2u);
  EXPECT_EQ(first.right.size(), 4u);
  EXPECT_EQ(first.head.formals.at(0).name, "y");
  EXPECT_TRUE(first.weight && first.guard);
  EXPECT_TRUE(system.productions[2].after);
  EXPECT_EQ(system.tables.at(0).productions.size(), 2u);
  EXPECT_TRUE(system.decompose.depth);
  EXPECT_EQ(system.interpret.productions.size(), 1u);
  EXPECT_EQ(system.schedule.size(), 2u);
  EXPECT_EQ(system.ignore.size(), 3u);
}

TEST(LSystemText, KnowsRulesByTheirArrows) {
  const Read read_rules = read(R"(grammar g: lsystem {
  axiom A(1)
  A(x) if max(x,
              2) > 1
    -> B(x,
         2)
    [+C]
  B(x, y) -> C
  + -> F(
    1)
})");
  EXPECT_EQ(read_rules.report, "");
  const LSystem& system = *read_rules.document.grammars.at(0).lsystem;
  ASSERT_EQ(system.productions.size(), 3u);
  EXPECT_EQ(names(system.productions[0].word), "B2 [ + C ]");
  EXPECT_EQ(names(system.productions[2].word), "F1");
}

TEST(LSystemText, WarnsOfConsecutiveLowerCaseLetters) {
  const Read algae = read("grammar g: lsystem {\n  axiom b\n  a -> ab\n  b -> a\n}\n");
  EXPECT_EQ(algae.report,
            "t.vug:3:8: warning: 'ab' is a single module without a rule\n  a -> ab\n"
            "       ^~\nhint: write spaces between lower-case letters: a b\n");
  EXPECT_FALSE(algae.document.grammars.at(0).broken);
  EXPECT_EQ(read("grammar g: lsystem {\n  axiom b\n  a -> a b ab\n  b -> a\n  ab -> c\n}\n").report,
            "");
}

struct Fault {
  const char* rules;
  const char* expected;  ///< A part of the report.
};

class LSystemFaults : public ::testing::TestWithParam<Fault> {};

TEST_P(LSystemFaults, AreReported) {
  const Read made =
      read(std::string("grammar g: lsystem {\n") + GetParam().rules + "\n}\nlet a = 1\n");
  EXPECT_NE(made.report.find(GetParam().expected), std::string::npos) << made.report;
  EXPECT_TRUE(made.document.grammars.at(0).broken);
  EXPECT_EQ(made.document.lets.size(), 1u) << "the following text is parsed";
}

INSTANTIATE_TEST_SUITE_P(
    Texts, LSystemFaults,
    ::testing::Values(
        Fault{"axiom F[+F", "t.vug:2:8: error: the '[' in the axiom is never closed"},
        Fault{"axiom F\nF -> F]F",
              "t.vug:3:7: error: ']' without a matching '[' in the rule of 'F'"},
        Fault{"axiom F\nF -> {F", "t.vug:3:6: error: the '{' in the rule of 'F' is never closed"},
        Fault{"axiom F\nF(x -> F(x)", "t.vug:3:5: error: expected ')'"},
        Fault{"axiom F\nF -> F(1\nA -> B",
              "t.vug:4:1: error: expected ')' to close 'F(' of line 3"},
        Fault{"axiom F\nF ->", "the rule of 'F' has no modules"},
        Fault{"axiom F\nF -> G H -> F", "a second rule on one line"},
        Fault{"axiom F\nF(1) -> G", "the parameters of 'F' in a rule's head must be names"},
        Fault{"axiom F\nA < B < C -> G", "duplicate '<' in the head of a rule"},
        Fault{"axiom F\nA B -> G", "a rule replaces one module, not 2"},
        Fault{"axiom F\n[ -> G", "'[' cannot be replaced"},
        Fault{"axiom F\n[A] < B -> G", "a left context cannot have branches"},
        Fault{"axiom F\nA > [B -> G", "unbalanced brackets in the right context"},
        Fault{"axiom F\nF -> 1F", "t.vug:3:6: error: expected a module, found the number 1"},
        Fault{"axiom F\nF -> F < G", "write contexts before the arrow"},
        Fault{"axiom A(1)\nA(x, y) -> F", "t.vug:2:7: error: 'A' has 1 parameter\n"},
        Fault{"axiom A\nA(x, x) -> F\n", "duplicate parameter 'x' in the head of a rule"},
        Fault{"axiom A\nA(pi) -> F\n", "'pi' is a keyword"},
        Fault{"F -> FF", "grammar 'g' has no axiom"},
        Fault{"axiom F\naxiom G", "grammar 'g' has two axioms"},
        Fault{"axiom F\nschedule spring\ntable sprnig { F -> G }", "did you mean 'sprnig'?"},
        Fault{"axiom F\ntable spring { F -> G }", "tables without a schedule"},
        Fault{"axiom F\ninterpret { F -> G }\ninterpret { F -> G }", "duplicate 'interpret' block"},
        Fault{"axiom F\nF @1 @2 -> G", "duplicate '@' in a rule"},
        Fault{"axiom F\nF -> [(1)]", "'[' takes no parameters"},
        Fault{"axiom F\nF -> G(x: 1)", "modules take their arguments by position"},
        Fault{"axiom F\ntable t { steps 3 }\nschedule t", "expected a rule, found 'steps'"}));

TEST(LSystemText, SignsAreInvalidElsewhere) {
  const Read made = read("let a = 1 ! 2\ngrammar g { axiom + box()\n  A -> + box() ' }\n");
  EXPECT_NE(made.report.find("t.vug:1:11: error: unexpected character '!'"), std::string::npos);
  EXPECT_NE(made.report.find("unexpected character '''"), std::string::npos) << made.report;
  EXPECT_NE(read("grammar g: lsystem {\n  axiom F\n}\nlet b = 1 | 2\n")
                .report.find("unexpected character '|'"),
            std::string::npos);
}

TEST(LSystemText, ABlockThatIsNeverClosed) {
  const Read made = read("grammar g: lsystem {\n  axiom F\n  F -> FF\n\nlet b = 1\n");
  EXPECT_NE(made.report.find("the '{' of grammar 'g' is never closed"), std::string::npos)
      << made.report;
  EXPECT_EQ(made.document.lets.size(), 1u);
}

TEST(LSystemText, ALineLikeAStatementTerminates) {
  const Read made =
      read("grammar g: lsystem {\n  axiom F\ntable t {\n F interpret {\n  F - {\n }\n}\n");
  EXPECT_TRUE(made.diagnostics.has_errors());
}

TEST(LSystemText, Formats) {
  const std::string ragged = R"(grammar  g :lsystem{
steps   5   # how often
axiom A( 1,2 )F-F  +F
+ -> -   # a sign
A(x,y)  if x>y->A(x*2,x+y)[ +F ]
  [-F]
B<A(x , y)@2->F!( 0.1 )'
Long(x)   ->nothing
table spring{
A->B    # in spring
}
interpret {depth 3; F->F{.+F}}
schedule spring*2
}
)";
  const std::string tidy = R"(grammar g: lsystem {
  steps 5  # how often
  axiom A(1, 2)F-F +F
  +                -> -  # a sign
  A(x, y) if x > y -> A(x*2, x+y)[ +F ]
      [-F]
  B < A(x, y) @2 -> F!(0.1)'
  Long(x)        -> nothing
  table spring {
    A -> B  # in spring
  }
  interpret { depth 3; F -> F{.+F} }
  schedule spring*2
}
)";
  EXPECT_EQ(format(ragged), tidy);
  EXPECT_EQ(format(tidy), tidy);
  EXPECT_EQ(dump(read(ragged).document), dump(read(tidy).document));
  EXPECT_EQ(read(ragged).report, "");
}

}  // namespace
}  // namespace vug::scene
