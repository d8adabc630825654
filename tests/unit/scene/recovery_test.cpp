// SPDX-License-Identifier: Apache-2.0
// An error neither hides other errors nor causes further ones.
#include "parsing.h"

namespace vug::scene {
namespace {

TEST(Recovery, EachStatementFailsAlone) {
  EXPECT_EQ(faults("let a = 1 +\nlet b = 2\nlet c = )\nlet d = (1,\nlet e = 5\nlet f = 6 6\n"),
            "1: expected a value, found the end of the line\n"
            "3: expected a value, found ')'\n"
            "5: expected ')' to close '(' of line 4, found 'e'\n"
            "6: expected the end of the line, found the number 6\n");
}

TEST(Recovery, EntriesAndRulesFailAlone) {
  EXPECT_EQ(faults("camera a {\n  fov = 3\n  eye (1, 2\n  roll 4 +\n}\nlet b = )\n"),
            "2: expected the value of 'fov', found '='\n"
            "4: expected ')' to close '(' of line 3, found 'roll'\n"
            "4: expected a value, found the end of the line\n"
            "6: expected a value, found ')'\n");
  EXPECT_EQ(faults("grammar g {\n  axiom A\n  A @ -> + f(1)\n  A -> + \n  A -> + g(1) * \n}\n"
                   "let a = )\n"),
            "3: expected a value, found '->'\n"
            "4: expected a value, found the end of the line\n"
            "5: expected a value, found the end of the line\n"
            "7: expected a value, found ')'\n");
}

TEST(Recovery, ALostBraceEndsAtTheNextStatement) {
  EXPECT_EQ(faults("camera a {\n  fov 3\nlet b = 4\nlet b = 5\n"),
            "1: the '{' of camera 'a' is never closed\n4: duplicate let 'b'\n");
}

TEST(Recovery, AnOpenBracketEndsAtTheNextStatement) {
  EXPECT_EQ(faults("let a = sphere(\nlet b = 4\nlet b = 5\n"),
            "2: expected ')' to close 'sphere(' of line 1, found 'b'\n3: duplicate let 'b'\n");
}

TEST(Recovery, ABinaryFileIsOneError) {
  EXPECT_EQ(faults(std::string(" BDV\0\0\x01 let\n\xff\xfe", 13)),
            "0: the file is not a text file\n");
  ParseOptions options;
  options.read = [](const std::filesystem::path&) { return std::string("l\0e\0t\0", 6); };
  EXPECT_EQ(faults("let a = 1\ninclude \"b.vug\"\n", options), "2: 'b.vug' is not a text file\n");
  EXPECT_EQ(faults(std::string("let a = 1  # caf\xe9\nlet b = \0 2\n", 29)), "2: invalid byte\n")
      << "a stray byte has its own location";
}

TEST(Recovery, ReportsShowOnlyPrintableText) {
  Diagnostics diagnostics;
  diagnostics.error({"a\xff.vug", 0, 0}, "no channel '\xd6\x01'", "see '\x1b[2J'");
  EXPECT_EQ(report(diagnostics, {}),
            "a\uFFFD.vug: error: no channel '\uFFFD\uFFFD'\nhint: see '\uFFFD[2J'\n");
}

TEST(Recovery, FaultsAreCapped) {
  std::string text;
  for (int i = 0; i < 500; ++i) text += "let a" + std::to_string(i) + " = )\n";
  Diagnostics diagnostics;
  parse(text, "t.vug", diagnostics);
  EXPECT_EQ(diagnostics.all().size(), 100u);
}

TEST(Report, SortsQuotesAndCounts) {
  auto source = std::make_shared<const Source>(Source{"a.vug", "one\n\t\xc3\xa4 two\n"});
  Diagnostics diagnostics;
  diagnostics.error({"a.vug", 2, 4}, "second", "do this");
  diagnostics.error({"a.vug", 1, 1}, "first");
  diagnostics.error({"a.vug", 1, 1}, "first");
  diagnostics.warning({"b.vug", 9, 9}, "elsewhere");
  EXPECT_EQ(report(diagnostics, {source}),
            "a.vug:1:1: error: first\none\n^\n"
            "a.vug:2:4: error: second\n\t\xc3\xa4 two\n\t  ^\nhint: do this\n"
            "b.vug:9:9: warning: elsewhere\n");
  EXPECT_EQ(report(diagnostics, {source}, 1), "a.vug:1:1: error: first\none\n^\n... and 2 more\n");
}

TEST(Recovery, LinesFurtherRightContinueAFaultyFunction) {
  const std::string text =
      "def post(x, lean  0deg) =\n    [x,\n    lean]\n    where tilt = 3\nlet q = post(1) + "
      "post(2)\n";
  EXPECT_EQ(faults(text), "1: expected ')' after the parameters, found the number 0deg\n");
}

}  // namespace
}  // namespace vug::scene
