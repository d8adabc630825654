// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <vug/base/error.h>
#include <vug/workbench/words.h>

namespace vug::workbench {
namespace {

TEST(Words, QuotesAndCommentsSurvive) {
  EXPECT_EQ(split_words("open \"a b.json\" # a comment"),
            (std::vector<std::string>{"open", "a b.json"}));
  EXPECT_EQ(split_words("select #2x"), (std::vector<std::string>{"select"}));
  EXPECT_TRUE(split_words("   # nothing").empty());
  for (const std::string word : {"", "plain", "two words", "a\"b\\c", "#2"})
    EXPECT_EQ(split_words("x " + quoted(word)), (std::vector<std::string>{"x", word}));
  EXPECT_THROW(split_words("open \"a"), Error);
}

TEST(Words, NumbersAndLengths) {
  EXPECT_EQ(parse_length("3.5"), 3.5);
  EXPECT_EQ(parse_length("3.5m"), 3.5);
  EXPECT_EQ(parse_length("-90cm"), -0.9);
  EXPECT_THROW(parse_length("3ft"), Error);
  EXPECT_THROW(parse_length("m"), Error);
  EXPECT_THROW(parse_number("4m"), Error);
}

}  // namespace
}  // namespace vug::workbench
