// SPDX-License-Identifier: Apache-2.0
// Fixed-point sums that do not depend on the order of their terms: numbers are rounded to a fixed
// unit once, then added as integers (a superaccumulator, Kulisch 2013, cite kulisch2013arithmetic,
// restricted to the range of light).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

namespace vug::render {

__extension__ typedef __int128 Wide;

/// Units of the sums: light in 2^-64, its square in 2^-48, all other values in 2^-24.
constexpr int kLightBits = 64, kSquareBits = 48, kPlainBits = 24;
/// Largest radiance of a sample (W/sr/m^2) and largest other value (metres): sums of 2^20 such
/// values and of their squares fit.
constexpr double kMaxLight = 0x1p28, kMaxPlain = 0x1p18;

/// v in units of 2^-bits, rounded towards zero. |v| must be less than 2^(126 - bits).
inline Wide to_wide(double v, int bits) {
  uint64_t pattern = 0;
  std::memcpy(&pattern, &v, sizeof pattern);
  const uint64_t mantissa = (pattern & 0xfffffffffffffull) | 0x10000000000000ull;
  const int shift = static_cast<int>(pattern >> 52 & 0x7ff) - 1075 + bits;
  if (shift <= -53) return 0;
  const Wide size =
      shift >= 0 ? static_cast<Wide>(mantissa) << shift : static_cast<Wide>(mantissa >> -shift);
  return pattern >> 63 ? -size : size;
}

/// sum * 2^-bits as a double, accurate to one unit in the last place.
inline double from_wide(Wide sum, int bits) {
  double step = 1;
  for (int b = 0; b < bits; ++b) step *= 0.5;
  const bool negative = sum < 0;
  const auto size =
      negative ? -static_cast<unsigned __int128>(sum) : static_cast<unsigned __int128>(sum);
  const double v = static_cast<double>(static_cast<uint64_t>(size >> 64)) * 0x1p64 +
                   static_cast<double>(static_cast<uint64_t>(size));
  return (negative ? -v : v) * step;
}

/// Converts values other than light, in 64 bits, clamped to kMaxPlain.
inline int64_t to_plain(float v) {
  const double most = kMaxPlain, step = 1 << kPlainBits;
  return std::llrint(std::clamp(static_cast<double>(v), -most, most) * step);
}
inline double from_plain(int64_t sum) { return static_cast<double>(sum) / (1 << kPlainBits); }

}  // namespace vug::render
