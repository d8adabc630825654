// SPDX-License-Identifier: Apache-2.0
#include <vug/base/maths.h>
#include <vug/base/rng.h>

#include <cmath>

namespace vug {

std::array<uint32_t, 4> philox4x32(std::array<uint32_t, 4> c, std::array<uint32_t, 2> k) {
  for (int round = 0; round < 10; ++round) {
    const uint64_t p0 = uint64_t{0xD2511F53} * c[0];
    const uint64_t p1 = uint64_t{0xCD9E8D57} * c[2];
    c = {static_cast<uint32_t>(p1 >> 32) ^ c[1] ^ k[0], static_cast<uint32_t>(p1),
         static_cast<uint32_t>(p0 >> 32) ^ c[3] ^ k[1], static_cast<uint32_t>(p0)};
    k[0] += 0x9E3779B9;
    k[1] += 0xBB67AE85;
  }
  return c;
}

namespace {

/// One Philox block as a mixing function of two 64-bit words.
uint64_t mix(uint64_t state, uint64_t word, uint32_t tag) {
  const auto out =
      philox4x32({static_cast<uint32_t>(word), static_cast<uint32_t>(word >> 32), tag, 0x766d6978},
                 {static_cast<uint32_t>(state), static_cast<uint32_t>(state >> 32)});
  return out[0] | uint64_t{out[1]} << 32;
}

}  // namespace

RandomKey RandomKey::at(std::string_view name) const {
  uint64_t state = state_;
  for (size_t i = 0; i < name.size(); i += 8) {
    uint64_t word = 0;
    for (size_t j = i; j < name.size() && j < i + 8; ++j)
      word |= uint64_t{static_cast<unsigned char>(name[j])} << (8 * (j - i));
    state = mix(state, word, 1);
  }
  return RandomKey(mix(state, name.size(), 2));
}

RandomKey RandomKey::at(uint64_t index) const { return RandomKey(mix(state_, index, 3)); }

uint32_t RandomStream::bits() {
  if (left_ == 0) {
    cache_ = philox4x32(
        {static_cast<uint32_t>(block_), static_cast<uint32_t>(block_ >> 32), 0, 0x76756773},
        {static_cast<uint32_t>(key_), static_cast<uint32_t>(key_ >> 32)});
    ++block_;
    left_ = 4;
  }
  return cache_[static_cast<size_t>(4 - left_--)];
}

double RandomStream::uniform() {
  const uint64_t high = bits() >> 5, low = bits() >> 6;  // 27 and 26 bits
  return static_cast<double>((high << 26) | low) * 0x1p-53;
}

uint32_t RandomStream::below(uint32_t count) {
  uint64_t product = uint64_t{bits()} * count;
  if (static_cast<uint32_t>(product) < count) {
    const uint32_t threshold = (0u - count) % count;
    while (static_cast<uint32_t>(product) < threshold) product = uint64_t{bits()} * count;
  }
  return static_cast<uint32_t>(product >> 32);
}

double RandomStream::normal() {
  for (;;) {
    const double x = uniform(-1, 1), y = uniform(-1, 1);
    const double s = x * x + y * y;
    if (s > 0 && s < 1) return x * std::sqrt(-2 * maths::log(s) / s);
  }
}

}  // namespace vug
