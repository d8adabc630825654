// SPDX-License-Identifier: Apache-2.0
// Counter-based random numbers: the same key and counter give the same number on any machine and in
// any thread. A key is derived from the seed and a path of names and indices, so adding a sibling
// elsewhere in a scene does not change existing random choices.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace vug {

/// One block of Philox4x32-10 (Salmon et al. 2011, "Parallel random numbers: as easy as
/// 1, 2, 3"): 128 random bits for a 128-bit counter under a 64-bit key.
std::array<uint32_t, 4> philox4x32(std::array<uint32_t, 4> counter, std::array<uint32_t, 2> key);

/// The key of a random choice: a seed followed by a path of names and indices.
class RandomKey {
 public:
  explicit RandomKey(uint64_t seed) : state_(seed) {}

  /// The key one step further down the path.
  RandomKey at(std::string_view name) const;
  RandomKey at(uint64_t index) const;

  uint64_t state() const { return state_; }

 private:
  uint64_t state_;
};

/// The sequence of random numbers of one key. A cheap value type.
class RandomStream {
 public:
  explicit RandomStream(RandomKey key) : key_(key.state()) {}

  uint32_t bits();
  /// Uniform in [0, 1) with 53 random bits.
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Uniform integer in 0..count-1; count > 0. Unbiased (Lemire 2019).
  uint32_t below(uint32_t count);
  /// Standard normal deviate (inverse-free polar method of Marsaglia).
  double normal();

 private:
  uint64_t key_;
  uint64_t block_ = 0;
  std::array<uint32_t, 4> cache_{};
  int left_ = 0;
};

}  // namespace vug
