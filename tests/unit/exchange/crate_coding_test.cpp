// SPDX-License-Identifier: Apache-2.0
// The compression of crate files: bytes derived by hand, and decoding by the reader of the tests.
#include <vug/base/error.h>
#include <vug/exchange/crate_coding.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "crate_file.h"

namespace vug::exchange {
namespace {

std::string encoded(const std::vector<int32_t>& numbers) {
  return crate_encode_integers(numbers.data(), numbers.size());
}

// The example of integerCoding.cpp: the differences are 123, 1, 1, 100000, 0, 1, 0.
TEST(CrateCoding, IntegersAreDifferencesWithCodesOfTwoBits) {
  const std::string expected(
      "\x01\0\0\0"      // the most frequent difference
      "\xc1\x11"        // codes 1 0 0 3, 1 0 1, the first in the lowest bits
      "\x7b"            // 123
      "\xa0\x86\x01\0"  // 100000
      "\0\0",           // 0, 0
      13);
  EXPECT_EQ(encoded({123, 124, 125, 100125, 100125, 100126, 100126}), expected);
  EXPECT_EQ(encoded({}), "");
  // Of equally frequent differences the largest; -300 has two bytes.
  EXPECT_EQ(encoded({7, -293}), std::string("\x07\0\0\0\x08\xd4\xfe", 7));
}

TEST(CrateCoding, AnyIntegersAreDecoded) {
  constexpr int32_t kLow = std::numeric_limits<int32_t>::min(),
                    kHigh = std::numeric_limits<int32_t>::max();
  std::mt19937 random(1);
  std::vector<std::vector<int32_t>> all = {{}, {0}, {kLow, kHigh, kLow, 0, -1}};
  for (const size_t size : {1u, 2u, 3u, 4u, 5u, 17u, 1000u})
    for (const int bits : {1, 7, 8, 9, 15, 16, 17, 31}) {
      all.emplace_back();
      for (size_t i = 0; i < size; ++i)
        all.back().push_back(static_cast<int32_t>(random() >> (32 - bits)) - (1 << (bits - 1)));
    }
  for (const std::vector<int32_t>& numbers : all) {
    const std::string code = encoded(numbers);
    EXPECT_LE(code.size(), crate_encoded_size(numbers.size()));
    EXPECT_EQ(CrateFile::decode(code, numbers.size()), numbers);
    EXPECT_EQ(crate_decode_integers(code, numbers.size()), numbers);
    if (numbers.empty()) continue;
    // A byte less, or a number more than the codes have room for.
    EXPECT_FALSE(crate_decode_integers(code.substr(0, code.size() / 2), numbers.size()));
    EXPECT_FALSE(crate_decode_integers(code, 100 * numbers.size() + 100));
  }
}

// Large differences are counted, too, if there are few of them.
TEST(CrateCoding, AConstantStepTakesTwoBits) {
  for (const int32_t step : {3, -40000, 1 << 20}) {
    std::vector<int32_t> numbers;
    for (int32_t i = 0; i < 1000; ++i) numbers.push_back(i * step);
    EXPECT_LE(encoded(numbers).size(), 4u + 250u + 4u) << step;
    EXPECT_EQ(CrateFile::decode(encoded(numbers), 1000), numbers);
  }
}

TEST(CrateCoding, BlocksOfLz4) {
  // So few bytes are literals: their number in the upper half of a byte.
  EXPECT_EQ(crate_compress("abc"), std::string("\0\x30"
                                               "abc",
                                               5));
  EXPECT_EQ(crate_compress(""), std::string("\0\0", 2));
  std::string text;
  for (int i = 0; i < 2000; ++i) text += std::to_string(i * i % 977) + " ";
  const std::string packed = crate_compress(text);
  EXPECT_LT(packed.size(), text.size());
  EXPECT_EQ(packed[0], '\0');
  EXPECT_EQ(CrateFile::inflate_block(packed.substr(1)), text);
  EXPECT_EQ(crate_decompress(packed, text.size()), text);
  EXPECT_EQ(crate_decompress(packed, 10 * text.size()), text);
  EXPECT_FALSE(crate_decompress(packed, text.size() - 1));
  EXPECT_FALSE(crate_decompress(packed.substr(0, packed.size() / 2), text.size()));
  EXPECT_FALSE(crate_decompress("", 10));
}

TEST(CrateCoding, LargeDataHaveSeveralBlocks) {
  constexpr size_t kBlock = 100;
  std::string text;
  for (int i = 0; i < 250; ++i) text += static_cast<char>(i * i / 7);
  const std::string packed = crate_compress(text, kBlock);
  EXPECT_EQ(packed[0], 3);
  std::string joined;
  size_t at = 1;
  for (int i = 0; i < 3; ++i) {
    int32_t size = 0;
    std::memcpy(&size, packed.data() + at, 4);
    const std::string part =
        CrateFile::inflate_block(packed.substr(at + 4, static_cast<size_t>(size)));
    EXPECT_EQ(part.size(), i < 2 ? kBlock : text.size() - 2 * kBlock);
    joined += part;
    at += 4 + static_cast<size_t>(size);
  }
  EXPECT_EQ(at, packed.size());
  EXPECT_EQ(joined, text);
  EXPECT_EQ(crate_decompress(packed, text.size(), kBlock), text);
  EXPECT_FALSE(crate_decompress(packed.substr(0, packed.size() - 1), text.size(), kBlock));
  EXPECT_THROW(crate_compress(std::string(128 * kBlock, 'x'), kBlock), Error);
  EXPECT_NO_THROW(crate_compress(std::string(127 * kBlock, 'x'), kBlock));
}

}  // namespace
}  // namespace vug::exchange
