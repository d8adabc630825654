// SPDX-License-Identifier: Apache-2.0
// The compression of OpenUSD's binary files (crate files), as defined by
// pxr/base/tf/fastCompression.cpp and pxr/usd/usd/integerCoding.cpp of OpenUSD.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vug::exchange {

/// The most bytes in one LZ4 block.
inline constexpr size_t kCrateBlock = 0x7E000000;

/// Compresses bytes with LZ4. The result begins with a byte: 0 if one LZ4 block follows, else the
/// number of blocks, each preceded by its size in 4 bytes. `block`: the most bytes in one LZ4
/// block. Throws Error(too_large) beyond 127 blocks.
std::string crate_compress(std::string_view bytes, size_t block = kCrateBlock);

/// Nothing if the data are damaged or have more than `most` bytes.
std::optional<std::string> crate_decompress(std::string_view bytes, size_t most,
                                            size_t block = kCrateBlock);

/// Encodes the differences between successive numbers, beginning with the difference to 0: the most
/// frequent difference in 4 bytes; two bits for each number, which are 0 for that difference and 1,
/// 2, 3 for differences of 1, 2, 4 bytes; these differences. Differences wrap around at 2^32.
/// Nothing for no numbers.
std::string crate_encode_integers(const int32_t* numbers, size_t count);

/// Nothing if `bytes` have fewer than `count` integers.
std::optional<std::vector<int32_t>> crate_decode_integers(std::string_view bytes, size_t count);

/// The maximum number of bytes in the encoding of `count` numbers.
constexpr size_t crate_encoded_size(size_t count) {
  return count == 0 ? 0 : sizeof(int32_t) + (count + 3) / 4 + count * sizeof(int32_t);
}

}  // namespace vug::exchange
