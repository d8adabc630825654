// SPDX-License-Identifier: Apache-2.0
// Random numbers for tracking through media, which needs an unknown number of them.
#pragma once

#include <vug/base/vec.h>

#include <cstdint>
#include <cstring>

namespace vug::render {

/// Seeded by two numbers of a sampler, so that a path gets the same numbers on any thread. PCG32
/// (O'Neill 2014, "PCG: a family of simple fast space-efficient statistically good algorithms for
/// random number generation", oneill2014pcg).
class TrackingRng {
 public:
  explicit TrackingRng(const Vec2f& begin) {
    uint32_t words[2];
    std::memcpy(words, begin.getValue(), sizeof words);
    state_ = (static_cast<uint64_t>(words[0]) << 32 | words[1]) * kFactor + kStep;
    next();
  }
  /// Uniform in [0, 1).
  float next() {
    const uint64_t old = state_;
    state_ = old * kFactor + kStep;
    const auto mixed = static_cast<uint32_t>(((old >> 18) ^ old) >> 27);
    const auto turn = static_cast<uint32_t>(old >> 59);
    const uint32_t bits = (mixed >> turn) | (mixed << ((32 - turn) & 31));
    return static_cast<float>(bits >> 8) * 0x1p-24f;
  }
  /// Three uniform numbers of 21 bits each, by the permutation RXS-M-XS of the same paper.
  Vec3f triple() {
    const uint64_t old = state_;
    state_ = old * kFactor + kStep;
    const uint64_t mixed = ((old >> ((old >> 59) + 5)) ^ old) * 12605985483714917081ull;
    const uint64_t bits = (mixed >> 43) ^ mixed;
    constexpr uint64_t kMask = (1 << 21) - 1;
    const auto part = [&](int shift) {
      return static_cast<float>((bits >> shift) & kMask) * 0x1p-21f;
    };
    return {part(1), part(22), part(43)};
  }

 private:
  static constexpr uint64_t kFactor = 6364136223846793005ull, kStep = 1442695040888963407ull;
  uint64_t state_;
};

/// Distance to the next tentative collision in mean free paths: -log(1 - u) to a relative error of
/// 1e-7, with the same bits on every machine.
inline float free_path(float u) {
  const float left = 1 - u;
  uint32_t bits = 0;
  std::memcpy(&bits, &left, sizeof bits);
  // left = m 2^e with m in [2/3, 4/3); log m = 2 atanh(s), s = (m - 1) / (m + 1), |s| <= 1/5.
  const uint32_t shifted = bits - 0x3f2aaaab;
  const auto e = static_cast<float>(static_cast<int32_t>(shifted) >> 23);
  bits = (shifted & 0x7fffff) + 0x3f2aaaab;
  float m = 0;
  std::memcpy(&m, &bits, sizeof m);
  const float s = (m - 1) / (m + 1), ss = s * s;
  const float rest = ss * (1.0f / 3 + ss * (1.0f / 5 + ss * (1.0f / 7 + ss * (1.0f / 9))));
  return -(e * 0.693147181f + 2 * (s + s * rest));
}

}  // namespace vug::render
