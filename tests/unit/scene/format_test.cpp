// SPDX-License-Identifier: Apache-2.0
// Formatting keeps the meaning and is idempotent.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/scene/format.h>

#include <filesystem>

#include "parsing.h"

namespace vug::scene {
namespace {

namespace fs = std::filesystem;

std::string meaning(const std::string& text) {
  Diagnostics diagnostics;
  ParseOptions options;
  options.read = [](const fs::path&) { return std::optional<std::string>(""); };
  const Document document = parse(text, "t.vug", diagnostics, options);
  std::string out = dump(document);
  for (const Diagnostic& one : diagnostics.all()) out += one.message + '\n';
  return out;
}

std::vector<fs::path> scenes() {
  std::vector<fs::path> all;
  for (const fs::path& folder : {fs::path(VUG_DATA), fs::path(VUG_TEST_DATA)})
    if (fs::exists(folder))
      for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".vug") all.push_back(entry.path());
  return all;
}

TEST(Format, TablesOfMaterialsAreAligned) {
  const std::string text =
      "object o on wall {\n  material by rock {\n    limestone -> grey\n    clay      -> f(1)\n"
      "  }\n}\n";
  EXPECT_EQ(
      format("object o on wall {\nmaterial by rock {\nlimestone->grey\nclay -> f( 1)\n}\n}\n"),
      text);
  EXPECT_EQ(format(text), text);
  const std::string line = "material m = by rock { limestone -> grey, otherwise -> f(1) }\n";
  EXPECT_EQ(format(line), line);
}

TEST(Format, EverySceneKeepsItsMeaningAndIsIdempotent) {
  ASSERT_GT(scenes().size(), 40u);
  for (const fs::path& path : scenes()) {
    const std::string text = read_text(path);
    const std::string once = format(text);
    EXPECT_EQ(format(once), once) << path;
    const bool broken = path.generic_string().find("/broken/") != std::string::npos;
    if (!broken) {
      EXPECT_EQ(meaning(once), meaning(text)) << path;
    }
  }
}

TEST(Format, ScenesInDataAreFormatted) {
  for (const fs::path& path : scenes()) {
    const std::string name = path.generic_string();
    if (name.find("/broken/") != std::string::npos || name.find("/ragged/") != std::string::npos)
      continue;
    EXPECT_EQ(format(read_text(path)), read_text(path)) << "run vug format on " << name;
  }
}

TEST(Format, AlignsColumns) {
  EXPECT_EQ(format("param A=1 in 0..2 \"doc\"\nparam LONG = 52%   in 0..1  \"more\"\n"),
            "param A    = 1    in 0..2  \"doc\"\nparam LONG = 52%  in 0..1  \"more\"\n");
  EXPECT_EQ(format("let a=1 # one\nlet bcd = (1,2)# two\n"),
            "let a   = 1       # one\nlet bcd = (1, 2)  # two\n");
  EXPECT_EQ(format("camera main {\neye (1,2,3)\n  target   (4,5,6)\n}\n"),
            "camera main {\n  eye    (1, 2, 3)\n  target (4, 5, 6)\n}\n");
  EXPECT_EQ(format("grammar g {\naxiom A*2\nA @3 -> + f(1) label +X\nA->- g(1, 2) label -Z\n}"),
            "grammar g {\n  axiom A*2\n  A @3 -> + f(1)     label +X\n"
            "  A    -> - g(1, 2)  label -Z\n}\n");
}

// `blend` and `label` are options above the rules and clauses of items within them.
TEST(Format, OptionsOfAGrammarAreNotContinued) {
  EXPECT_EQ(
      format("grammar g {\nlabel +X\n# why\nblend smooth(1)\naxiom + f(1)\nlabel -X\n}\n"),
      "grammar g {\n  label +X\n  # why\n  blend smooth(1)\n  axiom + f(1)\n      label -X\n}\n");
  EXPECT_EQ(format("grammar g {\nA -> + f(1)\n- f(2)\nblend round(1)\n}\n"),
            "grammar g {\n  A -> + f(1)\n      - f(2)\n      blend round(1)\n}\n");
}

TEST(Format, NamesOfRulesAndValuesOnTheNextLineAreIndented) {
  const std::string text =
      "light lamp[p in spots]\n"
      "    = sphere(center: p)\n"
      "grammar weed: lsystem {\n"
      "  axiom A(1)\n"
      "  A(x) if tall -> F(y)[+(turn)A(y)]\n"
      "      where y = x * 2, turn = 90deg,\n"
      "      tall = x > 2\n"
      "  A(x) -> F(y) where y = x\n"
      "  +    -> -\n"
      "}\n";
  EXPECT_EQ(format(text), text);
}

TEST(Format, KeepsCommentsAndSingleBlankLines) {
  EXPECT_EQ(format("\n\n# top\n\n\n\nlet a = 1\ncamera c {\n# in\n  fov 3 # eol\n}\n\n\n"),
            "# top\n\nlet a = 1\ncamera c {\n  # in\n  fov 3  # eol\n}\n");
}

TEST(Format, SpacesOperatorsAsWritten) {
  EXPECT_EQ(format("let a=b*c+ -d /e^2\n"), "let a = b*c + -d / e^2\n");
  EXPECT_EQ(format("let a = f( x:1,y :2 ) . g( [ 1,2 ] )\n"), "let a = f(x: 1, y: 2).g([1, 2])\n");
  EXPECT_EQ(format("let a = 1 .. 2\nlet b = a<b and not(c)\n"),
            "let a = 1..2\nlet b = a < b and not(c)\n");
}

TEST(Format, EntriesOnOneLineAreSeparated) {
  EXPECT_EQ(format("render main {spp 16 size 4x3 run a,b}\n"),
            "render main { spp 16  size 4x3  run a, b }\n");
}

}  // namespace
}  // namespace vug::scene
