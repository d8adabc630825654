// SPDX-License-Identifier: Apache-2.0
// Ranges of tokens and syntax trees: in every scene of the repository they nest, and the text in a
// range gives the same token or tree again.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/scene/lexer.h>
#include <vug/scene/parser.h>
#include <vug/scene/text_at.h>

#include <filesystem>
#include <regex>

#include "extents.h"
#include "parsing.h"

namespace vug::scene {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> all_scenes() {
  std::vector<fs::path> all;
  for (const char* folder : {VUG_DATA, VUG_TEST_DATA})
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == ".vug") all.push_back(entry.path());
  return all;
}

/// The canonical line of an expression without the keys of its calls, which depend on their place
/// in the document.
std::string without_keys(const std::string& line) {
  return std::regex_replace(line, std::regex("#[0-9a-f]+"), "");
}

/// The lists and the names of `by rock { NAME -> MATERIAL }`, which have no text of their own.
bool belongs_to_table(const Expr& expr, const std::string& text) {
  return (expr.kind == ExprKind::list && text.rfind("by rock", 0) == 0) ||
         (expr.kind == ExprKind::text && text.rfind('"', 0) != 0);
}

TEST(Extent, TheTextOfATokenIsThatToken) {
  ASSERT_GT(all_scenes().size(), 200u);
  for (const fs::path& path : all_scenes()) {
    const std::string text = normalise_text(read_text(path));
    Diagnostics ignored;
    for (const Token& token : lex(text, "t", ignored, true))
      EXPECT_EQ(
          text_at(text, {"t", token.line, token.column, token.end_line(), token.end_column()}),
          token.text)
          << path << ":" << token.line;
  }
}

TEST(Extent, RangesNest) {
  size_t checked = 0;
  for (const fs::path& path : all_scenes()) {
    Diagnostics diagnostics;
    const Document document = parse_file(path, diagnostics);
    if (diagnostics.has_errors()) continue;
    const auto nests = [&](const SourceLocation& parent, const SourceLocation& child) {
      ++checked;
      EXPECT_TRUE(parent.contains(child)) << range_text(parent) << " and " << range_text(child);
    };
    ExtentVisitor(nests, [](const Expr&) {}).document(document);
  }
  EXPECT_GT(checked, 40000u);
}

TEST(Extent, TheTextOfAnExpressionParsesToTheSameTree) {
  for (const fs::path& path : all_scenes()) {
    Diagnostics diagnostics;
    const Document document = parse_file(path, diagnostics);
    if (diagnostics.has_errors()) continue;
    const auto same = [&](const Expr& expr) {
      for (const auto& source : document.sources)
        if (source->file == expr.extent.file) {
          const std::string text(text_at(source->text, expr.extent));
          if (belongs_to_table(expr, text)) continue;
          EXPECT_EQ(without_keys(shape_of("(" + text + ")")), without_keys(dump(expr)))
              << range_text(expr.extent);
        }
    };
    ExtentVisitor([](const auto&, const auto&) {}, same).document(document);
  }
}

TEST(Extent, TheTextOfADeclarationIsItsWholeStatement) {
  const std::string text =
      "param R = 1m in 0m..2m \"radius\"  # note\n"
      "volume rock = level_set(\n  sphere(R), voxel: 1cm)\n"
      "skin wet on rock { a 1,\n  2  b (3 + 4) * 5 }\n"
      "grammar g { axiom A\n A -> + f(\u00b5: 1) * 2 label +X }\n";
  Diagnostics ignored;
  const Document document = parse(text, "t", ignored);
  const auto at = [&](const SourceLocation& where) {
    return std::string(text_at(document.sources[0]->text, where));
  };
  EXPECT_EQ(at(document.params[0].extent), "param R = 1m in 0m..2m \"radius\"");
  EXPECT_EQ(at(document.declarations[0].extent),
            "volume rock = level_set(\n  sphere(R), voxel: 1cm)");
  EXPECT_EQ(at(document.declarations[0].where), "rock");
  EXPECT_EQ(at(document.declarations[0].value->operands[1].where), "voxel: 1cm");
  const Declaration& skin = document.declarations[1];
  EXPECT_EQ(at(skin.entries[0].extent), "a 1,\n  2");
  EXPECT_EQ(at(skin.entries[1].extent), "b (3 + 4) * 5");
  EXPECT_EQ(at(skin.entries[1].values[0]->extent), "(3 + 4) * 5");
  EXPECT_EQ(at(skin.entries[1].values[0]->operands[0].value->extent), "3 + 4");
}

TEST(Extent, MethodsAndModules) {
  const Document document = parsed(
      "let a = x.b(1)\n  .c(2)\n"
      "grammar g: lsystem { axiom FA(1, 2)[?P(x)]\n A(l, w) if l > 1 -> FA(l,\n w) }\n");
  const auto at = [&](const SourceLocation& where) {
    return std::string(text_at(document.sources[0]->text, where));
  };
  EXPECT_EQ(at(document.lets[0].value->extent), "x.b(1)\n  .c(2)");
  EXPECT_EQ(at(document.lets[0].value->where), "c(2)");
  const LSystem& system = *document.grammars[0].lsystem;
  EXPECT_EQ(at(system.axiom[0].where), "F");
  EXPECT_EQ(at(system.axiom[1].where), "A(1, 2)");
  EXPECT_EQ(at(system.axiom[3].where), "?P(x)");
  EXPECT_EQ(at(system.productions[0].extent), "A(l, w) if l > 1 -> FA(l,\n w)");
  EXPECT_EQ(at(system.productions[0].head.where), "A(l, w)");
}

TEST(Extent, DiagnosticsUnderlineTheRange) {
  const auto reported = [](const std::string& text) {
    Diagnostics diagnostics;
    const Document document = parse(text, "t", diagnostics);
    return report(diagnostics, document.sources);
  };
  EXPECT_EQ(reported("let length = 2parsec + 1").substr(0, 83),
            "t:1:14: error: unknown unit 'parsec'\nlet length = 2parsec + 1\n"
            "             ^~~~~~~\n");
  Diagnostics diagnostics;
  diagnostics.error({"t", 1, 3, 2, 4}, "two lines");
  const auto source = std::make_shared<const Source>(Source{"t", "a b\u00e4c  \nd\n"});
  EXPECT_EQ(report(diagnostics, {source}), "t:1:3: error: two lines\na b\u00e4c  \n  ^~~\n");
}

}  // namespace
}  // namespace vug::scene
