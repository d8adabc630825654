// SPDX-License-Identifier: Apache-2.0
#include "derived.h"

#include <vug/facade/grammar_output.h>
#include <vug/scene/format.h>

#include <fmt/format.h>

#include <sstream>
#include <tuple>

namespace vug::facade {
namespace {

/// Kinds and positions of all elements except walls, in millimetres, sorted.
std::vector<std::tuple<std::string, int, int, int, int>> elements_of(const Tree& tree) {
  std::vector<std::tuple<std::string, int, int, int, int>> out;
  for (const ElementInstance& one : element_instances(tree)) {
    const std::string kind = tree.nodes[static_cast<size_t>(one.node)].element->kind();
    const auto mm = [](double metres) { return static_cast<int>(std::lround(metres * 1e3)); };
    if (kind != "wall")
      out.emplace_back(kind, mm(one.rect.x), mm(one.rect.y), mm(one.rect.width),
                       mm(one.rect.height));
  }
  std::sort(out.begin(), out.end());
  return out;
}

void expect_same_again(const std::string& rules, uint64_t seed = 0) {
  const Sample first = facade_of(rules, seed);
  ASSERT_EQ(first.said, "") << rules;
  const std::string text = grammar_text(first.tree);
  const Sample again(text, 99, first.tree.width, first.tree.height);
  ASSERT_EQ(again.said, "") << text;
  const auto before = elements_of(first.tree), after = elements_of(again.tree);
  ASSERT_EQ(before.size(), after.size()) << text;
  for (size_t i = 0; i < before.size(); ++i) {
    EXPECT_EQ(std::get<0>(before[i]), std::get<0>(after[i])) << text;
    EXPECT_NEAR(std::get<1>(before[i]), std::get<1>(after[i]), 1) << text;
    EXPECT_NEAR(std::get<2>(before[i]), std::get<2>(after[i]), 1) << text;
    EXPECT_NEAR(std::get<3>(before[i]), std::get<3>(after[i]), 1) << text;
    EXPECT_NEAR(std::get<4>(before[i]), std::get<4>(after[i]), 1) << text;
  }
}

TEST(GrammarText, DerivesToTheSameElements) {
  expect_same_again("axiom A\nA -> rows(3m, columns(1m, door, 1, shop), 1, B)\nB -> grid(window)");
  expect_same_again("axiom A\nA -> repeat(x, B, count: 3)\nB -> inset(20cm, 30cm, 1m, 2m, window)");
  expect_same_again("axiom A\nA -> mirror(B)\nB -> columns(1m, wall, 1, window, 2m, door)");
  expect_same_again("axiom A\nA -> mirror(B, 2m, C)\nB -> columns(1, door, 2, window)\nC -> shop");
  expect_same_again(
      "axiom A\nA -> recess(1m, B, front: columns(1, wall, 30cm, column))\nB -> niche");
}

TEST(GrammarText, KeepsRandomChoices) {
  for (uint64_t seed = 0; seed < 20; ++seed)
    expect_same_again(
        "axiom A\nA -> rows(R, P)\nR -> repeat(x, E, alike: false, even: false)\n"
        "P -> mirror(S, M)\nP -> repeat(x, S)\nS -> G\nM -> H\nE -> window\nE -> door\n"
        "G -> grid(window, door, regular: false, identical: false)\nH -> grid(window)",
        seed);
}

/// Unequal cells become columns with names, and no line is long.
TEST(GrammarText, UnequalCellsAreInNamedColumns) {
  const Sample sample = facade_of(
      "axiom A\nA -> inset(1m, 9m, 1m, 6m, window) inset(1m, 9m, 4m, 3m, window) "
      "inset(5m, 5m, 1m, 6m, window) inset(5m, 5.5m, 5m, 2m, window)");
  EXPECT_EQ(
      grammar_text(sample.tree, {.name = "front"}),
      "grammar front: facade {\n  width 12m\n  height 9m\n  axiom A\n\n"
      "  A -> columns(1m, wall, 2m, Column, 2m, wall, 2m, Column2, 1, wall)\n\n"
      "  Column2 -> rows(1m, wall, 2m, window, 2m, wall, 2m, inset(0m, 0.5m, 0m, 0m, window), "
      "1, wall)\n\n"
      "  Column -> rows(1m, wall, 2m, window, 1m, wall, 2m, window, 1, wall)\n}\n");
  for (uint64_t seed = 0; seed < 20; ++seed) {
    const Sample grid = facade_of(
        "axiom A\nA -> grid(E, columns: 7, rows: 6, gap: 30cm, identical: false)\nE -> window\n"
        "E -> inset(10cm, 0cm, door)\nE -> inset(0cm, 20cm, shop)",
        seed);
    std::istringstream lines(grammar_text(grid.tree));
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100U) << line;
    expect_same_again(
        "axiom A\nA -> grid(E, columns: 7, rows: 6, gap: 30cm, identical: false)\nE -> window\n"
        "E -> inset(10cm, 0cm, door)\nE -> inset(0cm, 20cm, shop)",
        seed);
  }
}

TEST(GrammarText, LongRulesAreWrappedAsTheFormatterDoes) {
  std::string insets;
  for (int i = 0; i < 8; ++i)
    insets += fmt::format(" inset({}m, {}m, {}m, {}m, window)", 0.5 + 1.4 * i, 10.5 - 1.4 * i,
                          0.5 + 0.5 * i, 6.5 - 0.5 * i);
  const Sample sample = facade_of("axiom A\nA ->" + insets);
  ASSERT_EQ(sample.said, "");
  const std::string text = grammar_text(sample.tree, {.name = "front"});
  EXPECT_NE(text.find(",\n    0.4m, wall, 1m, Column"), std::string::npos) << text;
  EXPECT_EQ(scene::format(text), text);
}

TEST(GrammarText, IsShortForSimpleFacades) {
  const Sample sample =
      facade_of("axiom A\nA -> grid(window(sash: 0), columns: 4, rows: 3, gap: 1m)");
  EXPECT_EQ(grammar_text(sample.tree, {.name = "front", .thickness = 1.25}),
            "grammar front: facade {\n  width 12m\n  height 9m\n  thickness 1.25m\n  axiom A\n\n"
            "  A -> grid(window(sash: 0), columns: 4, rows: 3, gap: [1m, 1m], "
            "margin: [0m, 0m, 0m, 0m])\n}\n");
}

TEST(GrammarText, ContainsTheArgumentsOfElements) {
  const std::string rules =
      "axiom A\nA -> columns(1, window(12cm, panes: [1, 2]), 1, W, 1, door(panels: 0))\n"
      "W -> window(head: round, reveal: 33cm)";
  const Sample first = facade_of(rules);
  const std::string text = grammar_text(first.tree);
  EXPECT_NE(text.find("window(sash: 0.12m, panes: [1, 2])"), std::string::npos) << text;
  EXPECT_NE(text.find("window(head: round, reveal: 0.33m)"), std::string::npos) << text;
  EXPECT_NE(text.find("door(panels: 0)"), std::string::npos) << text;
  const Sample again(text, 0, first.tree.width, first.tree.height);
  EXPECT_EQ(again.said, "") << text;
  EXPECT_EQ(grammar_text(again.tree), text);
}

TEST(GrammarText, AnEmptyTreeIsAWall) {
  Tree tree;
  tree.name = "bare", tree.width = 2, tree.height = 3;
  const Sample again(grammar_text(tree), 0, 2, 3);
  EXPECT_EQ(again.said, "");
  EXPECT_EQ(elements_csv(again.tree), "kind,x,y,width,height,mirrored\nwall,0,0,2,3,0\n");
}

}  // namespace
}  // namespace vug::facade
