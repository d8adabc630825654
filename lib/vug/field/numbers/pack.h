// SPDX-License-Identifier: Apache-2.0
// Eight single-precision numbers in one AVX register, for the batch mode of a formula. Every
// operation is exactly rounded or a fixed polynomial, so all lanes agree on all machines.
#pragma once

#include <vug/field/numbers/scalar.h>

#include <immintrin.h>

namespace vug::field {

struct PackMask {
  __m256 bits;
};
inline PackMask operator&(PackMask a, PackMask b) { return {_mm256_and_ps(a.bits, b.bits)}; }
inline PackMask operator|(PackMask a, PackMask b) { return {_mm256_or_ps(a.bits, b.bits)}; }
inline PackMask operator!(PackMask a) {
  return {_mm256_xor_ps(a.bits, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))};
}
inline bool any(PackMask a) { return _mm256_movemask_ps(a.bits) != 0; }

struct Pack {
  static constexpr int kLanes = 8;
  __m256 v;

  Pack() : v(_mm256_setzero_ps()) {}
  Pack(__m256 lanes) : v(lanes) {}                                  // NOLINT
  Pack(double all) : v(_mm256_set1_ps(static_cast<float>(all))) {}  // NOLINT
  explicit Pack(float all) : v(_mm256_set1_ps(all)) {}

  static Pack load(const float* lanes) { return _mm256_loadu_ps(lanes); }
  void store(float* lanes) const { _mm256_storeu_ps(lanes, v); }
  /// 0, 1, ..., 7.
  static Pack ramp() { return _mm256_setr_ps(0, 1, 2, 3, 4, 5, 6, 7); }
};

inline Pack operator+(Pack a, Pack b) { return _mm256_add_ps(a.v, b.v); }
inline Pack operator-(Pack a, Pack b) { return _mm256_sub_ps(a.v, b.v); }
inline Pack operator*(Pack a, Pack b) { return _mm256_mul_ps(a.v, b.v); }
inline Pack operator/(Pack a, Pack b) { return _mm256_div_ps(a.v, b.v); }
inline Pack operator-(Pack a) { return _mm256_xor_ps(a.v, _mm256_set1_ps(-0.0f)); }
inline Pack& operator+=(Pack& a, Pack b) { return a = a + b; }
inline Pack& operator-=(Pack& a, Pack b) { return a = a - b; }
inline Pack& operator*=(Pack& a, Pack b) { return a = a * b; }
inline PackMask operator<(Pack a, Pack b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LT_OQ)}; }
inline PackMask operator>(Pack a, Pack b) { return b < a; }
inline PackMask operator<=(Pack a, Pack b) { return {_mm256_cmp_ps(a.v, b.v, _CMP_LE_OQ)}; }
inline PackMask operator>=(Pack a, Pack b) { return b <= a; }

inline Pack sqrt(Pack x) { return _mm256_sqrt_ps(x.v); }
inline Pack abs(Pack x) { return _mm256_andnot_ps(_mm256_set1_ps(-0.0f), x.v); }
inline Pack min(Pack a, Pack b) { return _mm256_min_ps(a.v, b.v); }
inline Pack max(Pack a, Pack b) { return _mm256_max_ps(a.v, b.v); }
inline Pack floor(Pack x) { return _mm256_floor_ps(x.v); }
inline Pack select(PackMask m, Pack yes, Pack no) { return _mm256_blendv_ps(no.v, yes.v, m.bits); }

/// sin and cos of radians, |x| < 8192: Cephes' single-precision polynomials (Moshier 1989) after
/// a Cody-Waite reduction to [-pi/4, pi/4]; absolute error below 2e-7.
void sincos(Pack x, Pack& sine, Pack& cosine);
inline Pack sin(Pack x) {
  Pack s, c;
  sincos(x, s, c);
  return s;
}
inline Pack cos(Pack x) {
  Pack s, c;
  sincos(x, s, c);
  return c;
}
/// Relative error below 3e-7; 0 below -87, saturates above 88.
Pack exp(Pack x);
/// Angle of (x, y) in radians, in [-pi, pi]; absolute error below 4e-7.
Pack atan2(Pack y, Pack x);

}  // namespace vug::field
