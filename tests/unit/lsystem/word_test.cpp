// SPDX-License-Identifier: Apache-2.0
#include <vug/base/error.h>
#include <vug/lsystem/word.h>

#include <gtest/gtest.h>

#include <array>

namespace vug::lsystem {
namespace {

TEST(Alphabet, DistinguishesNamesByTheirParameters) {
  Alphabet alphabet;
  const SymbolId bare = alphabet.add("F", 0), with = alphabet.add("F", 1);
  EXPECT_EQ(bare, 0);
  EXPECT_EQ(with, 1);
  EXPECT_EQ(alphabet.add("F", 0), bare);
  EXPECT_EQ(alphabet.find("F", 1), with);
  EXPECT_EQ(alphabet.find("F", 2), std::nullopt);
  EXPECT_EQ(alphabet.find("G", 0), std::nullopt);
  EXPECT_EQ(alphabet.name(with), "F");
  EXPECT_EQ(alphabet.parameters(with), 1u);
  EXPECT_THROW(alphabet.add("A", Alphabet::kMaxParameters + 1), Error);
}

TEST(Word, KeepsEachModulesParameters) {
  Alphabet alphabet;
  const SymbolId a = alphabet.add("A", 2), b = alphabet.add("B", 1), plus = alphabet.add("+", 0);
  Word word;
  EXPECT_TRUE(word.empty());
  word.append(b, std::array{2.0});
  word.append(plus);
  word.append(a, std::array{4.0, 0.25});
  ASSERT_EQ(word.size(), 3u);
  EXPECT_EQ(word.symbol(2), a);
  EXPECT_EQ(word[2].parameters[1], 0.25);
  EXPECT_TRUE(word.parameters(1).empty());
  word.parameters(0)[0] = 3;
  EXPECT_EQ(to_string(word, alphabet), "B(3)+A(4,0.25)");
  EXPECT_EQ(to_string(word, alphabet, 1, 2), "+");
  EXPECT_EQ(word.values().size(), 3u);
}

TEST(Word, AppendsWords) {
  Alphabet alphabet;
  const SymbolId a = alphabet.add("A", 1), b = alphabet.add("B", 0);
  Word first, second;
  first.append(a, std::array{1.0});
  second.append(b);
  second.append(a, std::array{2.0});
  Word joined = first;
  joined.append(second);
  EXPECT_EQ(to_string(joined, alphabet), "A(1)BA(2)");
  EXPECT_FALSE(joined == first);
  joined.clear();
  joined.append(first[0]);
  EXPECT_TRUE(joined == first);
}

TEST(Word, PrintsNumbersInTheFewestDigits) {
  Alphabet alphabet;
  const SymbolId a = alphabet.add("A", 3);
  Word word;
  word.append(a, std::array{4.0, 0.1, -1e20});
  word.append(a, std::array{1.0 / 3, 100000.0, 1e-7});
  EXPECT_EQ(to_string(word, alphabet), "A(4,0.1,-1e+20)A(0.3333333333333333,100000,1e-07)");
}

}  // namespace
}  // namespace vug::lsystem
