// SPDX-License-Identifier: Apache-2.0
// Integer lanes for the number types, used by the hashes of lattice_hash.h.
#pragma once

#include <vug/field/numbers/pack.h>

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace vug::field {

template <class S>
struct Lanes;

template <>
struct Lanes<double> {
  using Int = uint32_t;
  static Int to_int(double x) {
    return static_cast<uint32_t>(static_cast<int64_t>(std::clamp(x, -1e9, 1e9)));
  }
  static Int multiply(Int a, uint32_t b) { return a * b; }
  static Int add(Int a, uint32_t b) { return a + b; }
  static Int bit_xor(Int a, Int b) { return a ^ b; }
  static Int bit_xor(Int a, uint32_t b, int) { return a ^ b; }
  static Int shift_right(Int a, int bits) { return a >> bits; }
  /// The low 24 bits as a number in [0, 1).
  static double to_unit(Int a) { return static_cast<double>(a & 0xffffff) * 0x1p-24; }
  /// Entry `index` of a table with eight entries.
  static double lookup(const float* table, Int index) { return static_cast<double>(table[index]); }
  /// -x if the top bit of `a` is set.
  static double flip_sign(double x, Int a) { return a >> 31 ? -x : x; }
};

template <>
struct Lanes<Pack> {
  using Int = __m256i;
  static Int to_int(Pack x) { return _mm256_cvtps_epi32(x.v); }
  static Int multiply(Int a, uint32_t b) {
    return _mm256_mullo_epi32(a, _mm256_set1_epi32(static_cast<int>(b)));
  }
  static Int add(Int a, uint32_t b) {
    return _mm256_add_epi32(a, _mm256_set1_epi32(static_cast<int>(b)));
  }
  static Int bit_xor(Int a, Int b) { return _mm256_xor_si256(a, b); }
  static Int bit_xor(Int a, uint32_t b, int) {
    return _mm256_xor_si256(a, _mm256_set1_epi32(static_cast<int>(b)));
  }
  static Int shift_right(Int a, int bits) { return _mm256_srli_epi32(a, bits); }
  static Pack to_unit(Int a) {
    return Pack(_mm256_cvtepi32_ps(_mm256_and_si256(a, _mm256_set1_epi32(0xffffff)))) *
           Pack(0x1p-24);
  }
  static Pack lookup(const float* table, Int index) {
    return _mm256_permutevar8x32_ps(_mm256_loadu_ps(table), index);
  }
  static Pack flip_sign(Pack x, Int a) {
    return _mm256_xor_ps(x.v, _mm256_and_ps(_mm256_castsi256_ps(a), _mm256_set1_ps(-0.0f)));
  }
};

inline bool any_lane(bool b) { return b; }
inline bool any_lane(PackMask m) { return any(m); }

}  // namespace vug::field
