// Random numbers for walks through a medium, of which nobody knows beforehand how many they take.
#pragma once

#include <vug/base/vec.h>

#include <cstdint>
#include <cstring>

namespace vug::render {

/// Begun by two numbers of a sampler, so that a path has the same ones on any thread. PCG32
/// (O'Neill 2014, "PCG: a family of simple fast space-efficient statistically good algorithms for
/// random number generation", oneill2014pcg).
class TrackingNumbers {
 public:
  explicit TrackingNumbers(const Vec2f& begin) {
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

 private:
  static constexpr uint64_t kFactor = 6364136223846793005ull, kStep = 1442695040888963407ull;
  uint64_t state_;
};

}  // namespace vug::render
