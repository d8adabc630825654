// SPDX-License-Identifier: Apache-2.0
// Helpers for eight lanes of AVX2 that compilers do not find on their own.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>

namespace vug::raytree {

/// For each 8-bit mask: the indices of its set bits in ascending order, one byte each.
inline constexpr std::array<uint64_t, 256> kCompressedLanes = [] {
  std::array<uint64_t, 256> all{};
  for (uint64_t mask = 0; mask < 256; ++mask) {
    int at = 0;
    for (uint64_t i = 0; i < 8; ++i)
      if (mask >> i & 1) all[mask] |= i << 8 * at++;
  }
  return all;
}();

/// Indices for _mm256_permutevar8x32 that move the lanes of the mask to the front; then zeros.
inline __m256i compressed_lanes(unsigned mask) {
  return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<int64_t>(kCompressedLanes[mask])));
}

}  // namespace vug::raytree
