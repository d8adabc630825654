// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/level_key.h>

#include <array>
#include <cstddef>
#include <utility>

namespace vug::cells {

void sort_by_level(std::vector<uint64_t>& keys) {
  constexpr int kBits = 11, kPasses = 3, kFirst = 32;
  constexpr size_t kDigits = size_t{1} << kBits;
  const auto digit = [](uint64_t key, int pass) {
    return static_cast<size_t>(key >> (kFirst + pass * kBits)) % kDigits;
  };
  std::array<std::vector<size_t>, kPasses> starts;
  for (std::vector<size_t>& each : starts) each.assign(kDigits, 0);
  for (const uint64_t key : keys)
    for (int pass = 0; pass < kPasses; ++pass)
      ++starts[static_cast<size_t>(pass)][digit(key, pass)];
  std::vector<uint64_t> sorted(keys.size());
  for (int pass = 0; pass < kPasses; ++pass) {
    std::vector<size_t>& start = starts[static_cast<size_t>(pass)];
    size_t before = 0;
    for (size_t& each : start) each = std::exchange(before, before + each);
    for (const uint64_t key : keys) sorted[start[digit(key, pass)]++] = key;
    keys.swap(sorted);
  }
}

}  // namespace vug::cells
