// SPDX-License-Identifier: Apache-2.0
// Texts that are being written: each prefix of each scene is answered and formatted.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/completion.h>
#include <vug/language/context.h>
#include <vug/language/hover.h>
#include <vug/language/outline.h>
#include <vug/language/semantic_tokens.h>
#include <vug/language/signature.h>
#include <vug/scene/format.h>

#include <cstdlib>

namespace vug::language {
namespace {

/// Answers the requests of an editor at the end of a text.
void answer(const std::string& text, const std::filesystem::path& file) {
  static Workspace workspace(with_data());
  workspace.open(file, text);
  const AnalysisPtr analysis = workspace.analyse(file);
  Position end{1, 1};
  if (!analysis->tokens.empty())
    end = {analysis->tokens.back().line, analysis->tokens.back().column};
  const Context context = context_at(*analysis, end);
  EXPECT_LE(begin_of(context.range), end);
  complete(workspace, *analysis, end);
  hover_at(*analysis, end);
  signatures_at(*analysis, end);
  outline_of(*analysis);
  workspace.close(file);
  const std::string formatted = scene::format(analysis->text);
  if (!analysis->diagnostics.has_errors()) {
    EXPECT_EQ(scene::format(formatted), formatted);
  }
}

TEST(Prefixes, OfAllScenesAreAnswered) {
  for (const auto& scene : data_scenes()) {
    const std::string text = read_text(scene);
    const size_t step = std::max<size_t>(1, text.size() / 25);
    for (size_t length = 0; length < text.size(); length += step)
      ASSERT_NO_THROW(answer(text.substr(0, length), scene)) << scene << " " << length;
  }
}

/// Every third prefix of the short scenes, and every 31st one of the others; all prefixes with
/// VUG_LONG_TESTS.
TEST(EveryPrefix, OfScenesIsAnswered) {
  const bool all = std::getenv("VUG_LONG_TESTS");
  for (const auto& scene : data_scenes()) {
    const std::string text = read_text(scene);
    const size_t step = all ? 1 : text.size() < 1200 ? 3 : 31;
    for (size_t length = 0; length <= text.size(); length += step)
      ASSERT_NO_THROW(answer(text.substr(0, length), scene)) << scene << " " << length;
  }
}

TEST(Prefixes, OneBrokenStatementLeavesTheOthers) {
  for (const char* broken : {"let x = sphere(", "mesh m on v {", "grammar g {\n  A -> +",
                             "def f(a, = 2", "param p = 3 in", "camera c { eye (1, 2"}) {
    const MarkedText text(std::string("let a = 1\n") + broken + "\nlet b = 2\nlight l = sky()\n");
    EXPECT_NE(text.analysis->document.find_let("a"), nullptr) << broken;
    EXPECT_NE(text.analysis->document.find_let("b"), nullptr) << broken;
    EXPECT_NE(text.analysis->document.find("l"), nullptr) << broken;
  }
}

}  // namespace
}  // namespace vug::language
