// SPDX-License-Identifier: Apache-2.0
// Definitions, references and renames, also across included texts.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/language/links.h>
#include <vug/language/navigation.h>
#include <vug/language/rename.h>

namespace vug::language {
namespace {

/// The texts of all files after a rename.
std::map<std::string, std::string> renamed(const Workspace& workspace, const SourceLocation& where,
                                           const std::string& name) {
  const AnalysisPtr text = workspace.analyse(where.file);
  std::map<std::string, std::string> texts;
  for (const auto& [file, edits] : rename(workspace, *text, begin_of(where), name))
    texts[file] = apply(scene::normalise_text(workspace.read(file).value_or("")), edits);
  return texts;
}

TEST(Rename, RenamingAndRenamingBackGivesTheSameBytes) {
  int renames = 0;
  for (const auto& scene : data_scenes()) {
    const std::string original = scene::normalise_text(read_text(scene));
    if (original.size() > 3000 || original.find("include") != std::string::npos) continue;
    Workspace workspace(with_data());
    workspace.open(scene, original);
    const AnalysisPtr before = workspace.analyse(scene);
    if (before->diagnostics.has_errors()) continue;
    for (const Symbol& symbol : before->symbols.symbols) {
      Workspace edited = workspace;
      const std::string name = symbol.kind == SymbolKind::rule ? "Zq" : "zq_renamed";
      try {
        for (const auto& [file, text] : renamed(edited, symbol.where, name))
          edited.open(file, text);
      } catch (const Error&) {
        continue;  // commands of the turtle
      }
      EXPECT_EQ(edited.read(scene)->find(original), std::string::npos);
      const AnalysisPtr after = edited.analyse(scene);
      EXPECT_FALSE(after->diagnostics.has_errors()) << scene << " " << symbol.name;
      EXPECT_EQ(after->symbols.references.size(), before->symbols.references.size());
      for (const auto& [file, text] : renamed(edited, symbol.where, symbol.name))
        edited.open(file, text);
      EXPECT_EQ(*edited.read(scene), original) << scene << " " << symbol.name;
      ++renames;
    }
  }
  EXPECT_GT(renames, 150);
}

/// Three texts: two scenes that include a library, one as a module.
class TwoScenes : public testing::Test {
 protected:
  TwoScenes() : workspace(with_data()) {
    workspace.open("/scenes/kit.vug",
                   "param level = 1m\ndef slab(h) = box(size: (1m, h, level))\n");
    workspace.open(
        "/scenes/a.vug",
        "include \"kit.vug\" as kit { level 2m }\nlet s = kit.slab(1m)\nlet t = kit.level\n");
    workspace.open("/scenes/b.vug", "include \"kit.vug\"\nlet u = slab(level)\n");
  }
  Workspace workspace;
};

TEST_F(TwoScenes, DefinitionsAndReferencesCrossFiles) {
  const AnalysisPtr a = workspace.analyse("/scenes/a.vug");
  const SourceLocation where = definition_at(*a, {2, 14});
  EXPECT_EQ(to_string(where), "/scenes/kit.vug:2:5");
  const auto symbol = symbol_at(*a, {3, 14});
  ASSERT_TRUE(symbol);
  std::vector<std::string> places;
  for (const Reference& each : references_of(workspace, *a, *symbol))
    places.push_back(to_string(each.where));
  EXPECT_EQ(places, (std::vector<std::string>{"/scenes/a.vug:1:28", "/scenes/a.vug:3:13",
                                              "/scenes/b.vug:2:14", "/scenes/kit.vug:1:7",
                                              "/scenes/kit.vug:2:33"}));
}

TEST_F(TwoScenes, RenameChangesAllTextsThatUseTheName) {
  const auto texts = renamed(workspace, {"/scenes/a.vug", 3, 14, 3, 15}, "height");
  EXPECT_EQ(texts.at("/scenes/kit.vug"),
            "param height = 1m\ndef slab(h) = box(size: (1m, h, height))\n");
  EXPECT_EQ(texts.at("/scenes/a.vug"),
            "include \"kit.vug\" as kit { height 2m }\nlet s = kit.slab(1m)\nlet t = kit.height\n");
  EXPECT_EQ(texts.at("/scenes/b.vug"), "include \"kit.vug\"\nlet u = slab(height)\n");
}

TEST_F(TwoScenes, RenameRefusesANameThatAnotherTextDeclares) {
  EXPECT_THROW(renamed(workspace, {"/scenes/kit.vug", 1, 7, 1, 12}, "u"), Error);
  EXPECT_THROW(renamed(workspace, {"/scenes/kit.vug", 1, 7, 1, 12}, "h"), Error);
}

TEST_F(TwoScenes, AnIncludeIsDefinedByItsFile) {
  const AnalysisPtr b = workspace.analyse("/scenes/b.vug");
  EXPECT_EQ(to_string(definition_at(*b, {1, 12})), "/scenes/kit.vug:1:1");
  const std::vector<Link> links = links_of(workspace, *b);
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].target, "/scenes/kit.vug");
  EXPECT_EQ(text_of(workspace, links[0].range), "kit.vug");
}

TEST(Rename, RefusesNamesThatAreWordsUnitsOrTaken) {
  const MarkedText text("let a = 1\nlet b = |a\nlet c = [for i in 0..2: a + i]\n");
  const auto refused = [&](const std::string& name) {
    try {
      rename(text.workspace, *text.analysis, text.position, name);
      return false;
    } catch (const Error& error) {
      EXPECT_FALSE(error.hint().empty());
      return true;
    }
  };
  for (const char* name : {"", "2a", "a b", "if", "cm", "b", "i", "\xc3\xa4"})
    EXPECT_TRUE(refused(name)) << name;
  EXPECT_FALSE(refused("d"));
}

TEST(Rename, RefusesTextsWithSyntaxErrors) {
  const MarkedText text("let |a = 1\nlet b = a +\n");
  EXPECT_THROW(rename(text.workspace, *text.analysis, text.position, "d"), Error);
}

}  // namespace
}  // namespace vug::language
