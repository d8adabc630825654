// SPDX-License-Identifier: Apache-2.0
// Properties of the symbol tables of all scenes, and scopes of local names.
#include "texts.h"

#include <gtest/gtest.h>

#include <vug/language/navigation.h>
#include <set>

namespace vug::language {
namespace {

TEST(Symbols, ReferencesInAllScenesAreNamesOfTheirSymbols) {
  const Workspace workspace(with_data());
  size_t references = 0;
  for (const auto& scene : data_scenes()) {
    const AnalysisPtr text = workspace.analyse(scene);
    for (const Reference& each : text->symbols.references) {
      const Symbol& symbol = text->symbols.of(each);
      EXPECT_EQ(text_of(workspace, each.where), symbol.name)
          << scene << " " << range_text(each.where);
      EXPECT_EQ(text_of(workspace, symbol.where), symbol.name)
          << scene << " " << range_text(symbol.where);
      ++references;
    }
  }
  EXPECT_GT(references, 5000u);
}

TEST(Symbols, EachParamLetAndFunctionOfASceneIsUsed) {
  // `vug check` warns of unused names in scenes; the tables must contain the uses, too.
  const Workspace workspace(with_data());
  for (const auto& scene : data_scenes()) {
    if (scene.string().find("/data/scenes/") == std::string::npos) continue;
    const AnalysisPtr text = workspace.analyse(scene);
    if (text->diagnostics.has_errors() || text->document.declarations.empty()) continue;
    std::set<int> used;
    for (const Reference& each : text->symbols.references)
      if (!each.declares) used.insert(each.symbol);
    for (size_t i = 0; i < text->symbols.symbols.size(); ++i) {
      const Symbol& symbol = text->symbols.symbols[i];
      const bool counts = symbol.kind == SymbolKind::param || symbol.kind == SymbolKind::let ||
                          symbol.kind == SymbolKind::function || symbol.kind == SymbolKind::local;
      if (counts && symbol.where.file == text->file) {
        EXPECT_TRUE(used.count(static_cast<int>(i))) << scene << " " << symbol.name;
      }
    }
  }
}

std::string definition_of(const std::string& marked) {
  const MarkedText text(marked);
  const SourceLocation where = definition_at(*text.analysis, text.position);
  return where.known() ? std::to_string(where.line) + ":" + std::to_string(where.column) : "none";
}

TEST(Symbols, LocalNamesHideGlobalOnesInTheirScope) {
  EXPECT_EQ(definition_of("let r = 1\ndef f(r) = |r + 1\nlet x = r\n"), "2:7");
  EXPECT_EQ(definition_of("let r = 1\ndef f(r) = r + 1\nlet x = |r\n"), "1:5");
  EXPECT_EQ(definition_of("let r = 1\ndef f(a) = |r + a where r = 2\n"), "2:24");
  EXPECT_EQ(definition_of("let i = 1\nlet x = [for i in 0..3: |i]\n"), "2:14");
  EXPECT_EQ(definition_of("let i = 1\nlet x = [for j in [|i]: j]\n"), "1:5");
}

TEST(Symbols, DeclarationsAreFoundByTheExpectedType) {
  const std::string scene =
      "volume rock = level_set(sphere(1m), voxel: 5cm)\n"
      "mesh rock on rock {}\n"
      "material rock = lambert()\n";
  EXPECT_EQ(definition_of(scene + "object a on |rock { material rock }\n"), "2:6");
  EXPECT_EQ(definition_of(scene + "object a on rock { material |rock }\n"), "3:10");
  EXPECT_EQ(
      definition_of("volume rock = level_set(sphere(1m), voxel: 5cm)\nmesh rock on |rock {}\n"),
      "1:8");
}

TEST(Symbols, RulesAndModulesOfGrammarsAreSymbols) {
  EXPECT_EQ(definition_of("grammar g {\n  axiom |Room\n  Room -> + sphere(1m)\n}\n"), "3:3");
  EXPECT_EQ(definition_of("grammar g: lsystem {\n  axiom FA\n  A -> F[+|A]\n}\n"), "3:3");
  EXPECT_EQ(definition_of("grammar g {\n  axiom A(2)\n  A(n) if |n > 0 -> A(n - 1)\n}\n"), "3:5");
}

TEST(Symbols, WordsOfAParameterAreNotReferences) {
  // `perspective` is a word of the entry `kind`, also if the text declares something of that name.
  EXPECT_EQ(definition_of(
                "let orthographic = 1\ncamera c { kind |orthographic  eye (0, 0, 3)  target (0, 0, "
                "orthographic) }\n"),
            "none");
}

TEST(Symbols, BrokenStatementsKeepUncertainReferences) {
  const MarkedText text("let size = 1m\nlet a = sphere(size\nlet b = |size + )\n");
  const Reference* found = text.analysis->symbols.at(text.analysis->file, text.position);
  ASSERT_NE(found, nullptr);
  EXPECT_FALSE(found->certain);
  EXPECT_EQ(text.analysis->symbols.of(*found).where.line, 1);
}

}  // namespace
}  // namespace vug::language
