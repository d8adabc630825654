// SPDX-License-Identifier: Apache-2.0
// Every ```vug example of docs/reference/language.md is a scene without errors.
#include <gtest/gtest.h>
#include <vug/base/atomic_file.h>
#include <vug/scene/format.h>

#include <filesystem>

#include "parsing.h"

namespace vug::scene {
namespace {

std::vector<std::string> examples() {
  const auto page =
      std::filesystem::path(VUG_DATA).parent_path() / "docs" / "reference" / "language.md";
  const std::string text = read_text(page);
  std::vector<std::string> all;
  const std::string open = "```vug\n", close = "```";
  for (size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    const size_t end = text.find(close, at);
    all.push_back(text.substr(at, end - at));
    at = end;
  }
  return all;
}

TEST(Language, ExamplesParseAndAreFormatted) {
  ASSERT_GE(examples().size(), 10u);
  for (const std::string& example : examples()) {
    Diagnostics diagnostics;
    ParseOptions options;
    options.read = [](const std::filesystem::path& path) -> std::optional<std::string> {
      const auto file = std::filesystem::path(VUG_DATA) / path;
      return std::filesystem::exists(file) ? read_text(file) : std::string();
    };
    const Document document = parse(example, "language.md", diagnostics, options);
    EXPECT_EQ(report(diagnostics, document.sources), "");
    EXPECT_EQ(format(example), example);
  }
}

}  // namespace
}  // namespace vug::scene
