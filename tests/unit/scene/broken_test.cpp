// SPDX-License-Identifier: Apache-2.0
// Every text in tests/data/broken/syntax is reported exactly as its .expected file says.
// A first line "# run: -D NAME=EXPR" gives an override. With VUG_UPDATE=1 in the environment the
// expected files are rewritten; review the difference before committing it.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/scene/check.h>
#include <vug/scene/parser.h>
#include <vug/scene/report.h>

#include <cstdlib>
#include <filesystem>

#include "fake_resolver.h"

namespace vug::scene {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> broken_scenes() {
  std::vector<fs::path> all;
  for (const auto& entry : fs::directory_iterator(fs::path(VUG_TEST_DATA) / "broken" / "syntax"))
    if (entry.path().extension() == ".vug") all.push_back(entry.path());
  std::sort(all.begin(), all.end());
  return all;
}

std::string diagnose(const fs::path& path) {
  const std::string text = read_text(path);
  EvaluatorOptions options;
  const std::string run = "# run: -D ";
  if (text.compare(0, run.size(), run) == 0) {
    const std::string given = text.substr(run.size(), text.find('\n') - run.size());
    options.overrides.push_back(
        {given.substr(0, given.find('=')), given.substr(given.find('=') + 1)});
  }
  ParseOptions parsing;
  parsing.read = [&](const fs::path& wanted) -> std::optional<std::string> {
    const fs::path file = path.parent_path() / wanted;
    if (!fs::exists(file)) return std::nullopt;
    return read_text(file);
  };
  Diagnostics diagnostics;
  const Document document = parse_file(path.filename(), diagnostics, parsing);
  FakeResolver resolver;
  Evaluator evaluator(document, resolver, diagnostics, options);
  evaluate_all(evaluator, document);
  if (!diagnostics.has_errors()) check_unused_names(document, diagnostics);
  EXPECT_FALSE(diagnostics.all().empty()) << path;
  return report(diagnostics, evaluator.sources());
}

// One test for all of them, because each test is a process.
TEST(BrokenTexts, AreReportedAsExpected) {
  for (const fs::path& text : broken_scenes()) {
    SCOPED_TRACE(text.filename().string());
    fs::path expected = text;
    expected.replace_extension(".expected");
    const std::string found = diagnose(text);
    if (std::getenv("VUG_UPDATE")) write_text(expected, found);
    EXPECT_EQ(found, read_text(expected));
  }
}

}  // namespace
}  // namespace vug::scene
