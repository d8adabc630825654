// SPDX-License-Identifier: Apache-2.0
// Hover over the words of a text.
#include "texts.h"

#include <gtest/gtest.h>
#include <vug/language/hover.h>

namespace vug::language {
namespace {

std::string hover(const std::string& marked) {
  const MarkedText text(marked);
  const auto found = hover_at(*text.analysis, text.position);
  return found ? found->text : "";
}

testing::AssertionResult contains(const std::string& text, const std::string& part) {
  if (text.find(part) != std::string::npos) return testing::AssertionSuccess();
  return testing::AssertionFailure() << "'" << part << "' is not in: " << text;
}

TEST(Hover, SymbolsHaveTheirDeclarationCommentAndValue) {
  const std::string text =
      hover("param size = 3cm in 1cm..9cm \"edge of a block\"\nlet a = box(size: 2 * |size)\n");
  EXPECT_TRUE(contains(text, "param size = 3cm in 1cm..9cm"));
  EXPECT_TRUE(contains(text, "edge of a block"));
  EXPECT_TRUE(contains(text, "Value: `0.03m`"));
  EXPECT_TRUE(contains(hover("# The bed of the stream.\nlet bed = 1m\nlet b = |bed\n"),
                       "The bed of the stream."));
}

TEST(Hover, ParametersHaveTheirTypeRangeAndDefault) {
  const std::string fov = hover("camera c { f|ov 40deg }\n");
  EXPECT_TRUE(contains(fov, "angle"));
  EXPECT_TRUE(contains(fov, "default"));
  EXPECT_TRUE(contains(hover("let a = torus(rad|ius: 1m)\n"), "radius"));
}

TEST(Hover, KindsDependOnTheExpectedType) {
  EXPECT_TRUE(contains(hover("light a = sph|ere(radius: 1m)\n"), "-> light"));
  EXPECT_TRUE(contains(hover("volume a = level_set(sph|ere(1m), voxel: 1cm)\n"), "-> field"));
  EXPECT_TRUE(contains(hover("let a = sq|rt(2)\n"), "square root"));
  EXPECT_TRUE(contains(hover("par|am a = 2\n"), "param NAME"));
  EXPECT_TRUE(contains(hover("mes|h m on v {}\n"), "mesh"));
}

TEST(Hover, CommentsAndNumbersHaveNone) {
  EXPECT_EQ(hover("# sph|ere\n"), "");
  EXPECT_EQ(hover("let a = 1|2\n"), "");
}

}  // namespace
}  // namespace vug::language
