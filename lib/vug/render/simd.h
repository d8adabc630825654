// Eight numbers at a time, where compilers do not find the way by themselves.
#pragma once

#include <immintrin.h>

#include <array>
#include <cstdint>

namespace vug::render {

/// Lanes i whose bit of the mask is set, in order; eight bytes each.
inline constexpr std::array<uint64_t, 256> kChosenLanes = [] {
  std::array<uint64_t, 256> all{};
  for (uint64_t mask = 0; mask < 256; ++mask) {
    int at = 0;
    for (uint64_t i = 0; i < 8; ++i)
      if (mask >> i & 1) all[mask] |= i << 8 * at++;
  }
  return all;
}();

/// Numbers of the chosen lanes, then zeros: for _mm256_permutevar8x32.
inline __m256i chosen_lanes(unsigned mask) {
  return _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(static_cast<int64_t>(kChosenLanes[mask])));
}

inline float sum_of_lanes(__m256 v) {
  const __m128 four = _mm_add_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  const __m128 two = _mm_add_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_add_ss(two, _mm_movehdup_ps(two)));
}
inline float most_of_lanes(__m256 v) {
  const __m128 four = _mm_max_ps(_mm256_castps256_ps128(v), _mm256_extractf128_ps(v, 1));
  const __m128 two = _mm_max_ps(four, _mm_movehl_ps(four, four));
  return _mm_cvtss_f32(_mm_max_ss(two, _mm_movehdup_ps(two)));
}

}  // namespace vug::render
