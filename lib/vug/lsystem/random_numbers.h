// SPDX-License-Identifier: Apache-2.0
// Random numbers of modules, generated in batches.
//
// A module's key is derived from its path from the axiom, so a branch keeps its numbers whatever
// happens in other branches, and no number depends on the position in the word, on chunks or on
// threads. The numbers are those of Philox4x32-10 (salmon2011philox) under the system's key, at the
// counter (key of the module, block, salt). A block gives two numbers, so selecting a rule and
// drawing one parameter cost one block. Eight blocks are computed at once.
#pragma once

#include <vug/base/uninitialized_vector.h>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vug::lsystem {

/// The key of the module at the 1-based position `place` in the successor of a module with `key`;
/// place 0 is the module itself in the next step. `salt` distinguishes stages. Uses Splitmix's
/// finaliser (steele2014splitmix): keys only need to differ, as Philox generates the numbers.
inline uint64_t child_key(uint64_t key, uint64_t place, uint32_t salt) {
  uint64_t z = key + 0x9E3779B97F4A7C15 * (place + 1 + (uint64_t{salt} << 32));
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EB;
  return z ^ (z >> 31);
}

/// The number of blocks that contain the numbers 0..last.
constexpr uint32_t blocks_with(uint32_t last) { return last / 2 + 1; }

class RandomNumbers {
 public:
  RandomNumbers(uint64_t system_key, uint32_t salt) : system_key_(system_key), salt_(salt) {}

  void clear() { counters_.clear(), blocks_.clear(); }

  /// Requests the first 2 * `blocks` numbers of a module.
  void request(uint64_t key, uint32_t blocks) {
    for (uint32_t block = 0; block < blocks; ++block) {
      counters_.push_back(key);
      blocks_.push_back(block);
    }
  }

  /// All requested numbers in order, uniform in [0, 1) with 52 random bits. Valid until the next
  /// call.
  const double* generate();

 private:
  uint64_t system_key_;
  uint32_t salt_;
  std::vector<uint64_t> counters_;
  std::vector<uint32_t> blocks_;
  UninitializedVector<double> numbers_;
};

}  // namespace vug::lsystem
