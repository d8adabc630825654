// SPDX-License-Identifier: Apache-2.0
// Internal to passages/: permutations that move some lanes of a pack to its front and back.
#pragma once

#include <vug/field/numbers/pack.h>

#include <array>
#include <cstdint>

namespace vug::passages {

using LaneTable = std::array<std::array<uint8_t, 8>, 256>;

/// For each set of lanes, their indices in ascending order.
inline constexpr LaneTable kLanesOf = [] {
  LaneTable table{};
  for (size_t bits = 0; bits < 256; ++bits)
    for (size_t lane = 0, count = 0; lane < 8; ++lane)
      if (bits >> lane & 1) table[bits][count++] = static_cast<uint8_t>(lane);
  return table;
}();

/// For each set of lanes, the index of each of its lanes in the order above.
inline constexpr LaneTable kRanksOf = [] {
  LaneTable table{};
  for (size_t bits = 0; bits < 256; ++bits)
    for (size_t lane = 0, count = 0; lane < 8; ++lane)
      if (bits >> lane & 1) table[bits][lane] = static_cast<uint8_t>(count++);
  return table;
}();

inline __m256i lane_order(const LaneTable& table, unsigned lanes) {
  const auto* indices = reinterpret_cast<const __m128i*>(table[lanes].data());
  return _mm256_cvtepu8_epi32(_mm_loadl_epi64(indices));
}
inline field::Pack permuted(field::Pack x, __m256i order) {
  return _mm256_permutevar8x32_ps(x.v, order);
}
/// The lanes of a set as a mask.
inline field::PackMask mask_of(unsigned lanes) {
  const __m256i bits = _mm256_setr_epi32(1, 2, 4, 8, 16, 32, 64, 128);
  const __m256i set = _mm256_and_si256(_mm256_set1_epi32(static_cast<int>(lanes)), bits);
  return {_mm256_castsi256_ps(_mm256_cmpeq_epi32(set, bits))};
}

}  // namespace vug::passages
