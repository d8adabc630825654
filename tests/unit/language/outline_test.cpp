// SPDX-License-Identifier: Apache-2.0
// The structure of texts: outline, folding, semantic tokens. Properties of all scenes.
#include "texts.h"

#include <gtest/gtest.h>

#include <vug/language/outline.h>
#include <vug/language/semantic_tokens.h>
#include <set>

namespace vug::language {
namespace {

void check_items(const std::vector<OutlineItem>& items, const std::string& what) {
  for (const OutlineItem& item : items) {
    EXPECT_TRUE(item.extent.contains(item.where)) << what << " " << item.name;
    for (const OutlineItem& child : item.children)
      EXPECT_TRUE(item.extent.contains(child.extent)) << what << " " << child.name;
    check_items(item.children, what);
  }
}

TEST(Outline, ItemsContainTheirNamesAndChildren) {
  const Workspace workspace(with_data());
  size_t items = 0;
  for (const auto& scene : data_scenes()) {
    const auto outline = outline_of(*workspace.analyse(scene));
    check_items(outline, scene);
    items += outline.size();
  }
  EXPECT_GT(items, 1500u);
}

TEST(Outline, AGrammarContainsItsRulesOnce) {
  const MarkedText text(
      "grammar g {\n  axiom A\n  A -> B\n  B @ 2 -> A\n  B -> + box()\n}\nlet x = 1\n");
  const auto outline = outline_of(*text.analysis);
  ASSERT_EQ(outline.size(), 2u);
  EXPECT_EQ(outline[0].detail, "grammar");
  ASSERT_EQ(outline[0].children.size(), 2u);
  EXPECT_EQ(outline[0].children[1].name, "B");
}

TEST(Folds, ContainSeveralLinesOfTheText) {
  const Workspace workspace(with_data());
  for (const auto& scene : data_scenes()) {
    const AnalysisPtr text = workspace.analyse(scene);
    const int lines = 1 + static_cast<int>(std::count(text->text.begin(), text->text.end(), '\n'));
    int last = 0;
    for (const Fold& fold : folds_of(*text)) {
      EXPECT_GT(fold.last_line, fold.first_line);
      EXPECT_GT(fold.first_line, last);
      EXPECT_LE(fold.last_line, lines);
      last = fold.first_line;
    }
  }
  const MarkedText text("# a\n# b\nlet x = [\n  1\n]\n\n# c\n");
  const auto folds = folds_of(*text.analysis);
  ASSERT_EQ(folds.size(), 2u);
  EXPECT_TRUE(folds[0].comment);
  EXPECT_EQ(folds[1].last_line, 5);
}

TEST(SemanticTokens, AreOrderedAndCoverAllNames) {
  const Workspace workspace(with_data());
  for (const auto& scene : data_scenes()) {
    const AnalysisPtr text = workspace.analyse(scene);
    Position last{1, 1};
    std::set<Position> begins;
    for (const SemanticToken& token : semantic_tokens(*text)) {
      EXPECT_GE(begin_of(token.where), last) << scene << " " << range_text(token.where);
      last = end_of(token.where);
      begins.insert(begin_of(token.where));
    }
    for (const scene::Token& token : text->tokens) {
      if (token.kind == scene::TokenKind::name || token.kind == scene::TokenKind::number) {
        EXPECT_TRUE(begins.count({token.line, token.column})) << scene << token.line;
      }
    }
  }
}

TEST(SemanticTokens, MeaningsOfAStatement) {
  const MarkedText text("param r = 1m\nvolume v = level_set(sphere(radius: r), voxel: 2cm)\n");
  using M = TokenMeaning;
  std::vector<M> meanings;
  for (const SemanticToken& token : semantic_tokens(*text.analysis))
    meanings.push_back(token.meaning);
  EXPECT_EQ(meanings,
            (std::vector<M>{M::keyword, M::param, M::number, M::keyword, M::declaration, M::kind,
                            M::kind, M::argument, M::param, M::argument, M::number}));
}

}  // namespace
}  // namespace vug::language
