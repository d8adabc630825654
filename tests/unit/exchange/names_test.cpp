// SPDX-License-Identifier: Apache-2.0
#include <vug/exchange/names.h>

#include <gtest/gtest.h>

namespace vug::exchange {
namespace {

TEST(UniqueNames, AreLettersDigitsAndUnderscores) {
  EXPECT_EQ(identifier("rock"), "rock");
  EXPECT_EQ(identifier("heap/stone 1"), "heap_stone_1");
  EXPECT_EQ(identifier("2nd"), "_2nd");
  EXPECT_EQ(identifier(""), "_");
  EXPECT_EQ(identifier("h\xc3\xb6hle"), "h__hle");
}

TEST(UniqueNames, AreUnique) {
  UniqueNames names;
  EXPECT_EQ(names.unique("a b"), "a_b");
  EXPECT_EQ(names.unique("a/b"), "a_b_2");
  EXPECT_EQ(names.unique("a_b_2"), "a_b_2_2");
  EXPECT_EQ(names.unique("a b"), "a_b_3");
}

}  // namespace
}  // namespace vug::exchange
