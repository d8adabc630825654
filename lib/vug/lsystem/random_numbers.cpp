// SPDX-License-Identifier: Apache-2.0
#include <vug/lsystem/random_numbers.h>

#include <immintrin.h>

namespace vug::lsystem {

namespace {

/// Four blocks in parallel; each 64-bit lane contains a 32-bit word. The upper halves are
/// undefined, but multiplication ignores them.
struct Lanes {
  __m256i a, b, c, d;
};

__m256i broadcast(int64_t value) { return _mm256_set1_epi64x(value); }

Lanes load(const uint64_t* counters, const uint32_t* blocks, uint32_t salt) {
  const __m256i counter = _mm256_loadu_si256(reinterpret_cast<const __m256i*>(counters));
  return {counter, _mm256_srli_epi64(counter, 32),
          _mm256_cvtepu32_epi64(_mm_loadu_si128(reinterpret_cast<const __m128i*>(blocks))),
          broadcast(salt)};
}

void round(Lanes& x, __m256i key0, __m256i key1) {
  const __m256i p0 = _mm256_mul_epu32(x.a, broadcast(0xD2511F53));
  const __m256i p1 = _mm256_mul_epu32(x.c, broadcast(0xCD9E8D57));
  x.a = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(p1, 32), x.b), key0);
  x.b = p1;
  x.c = _mm256_xor_si256(_mm256_xor_si256(_mm256_srli_epi64(p0, 32), x.d), key1);
  x.d = p0;
}

/// Uses 52 of 64 random bits as the mantissa of a number in [1, 2) and subtracts 1.
__m256d uniform(__m256i high, __m256i low) {
  const __m256i bits = _mm256_blend_epi32(_mm256_slli_epi64(high, 32), low, 0b01010101);
  const __m256i one = broadcast(0x3FF0000000000000);
  return _mm256_sub_pd(_mm256_castsi256_pd(_mm256_or_si256(_mm256_srli_epi64(bits, 12), one)),
                       _mm256_castsi256_pd(one));
}

void store(const Lanes& x, double* out) {
  const __m256d first = uniform(x.a, x.b), second = uniform(x.c, x.d);
  const __m256d even = _mm256_unpacklo_pd(first, second), odd = _mm256_unpackhi_pd(first, second);
  _mm256_storeu_pd(out, _mm256_permute2f128_pd(even, odd, 0x20));
  _mm256_storeu_pd(out + 4, _mm256_permute2f128_pd(even, odd, 0x31));
}

}  // namespace

const double* RandomNumbers::generate() {
  const size_t count = (counters_.size() + 7) / 8 * 8;
  counters_.resize(count);
  blocks_.resize(count);
  numbers_.resize(2 * count);
  for (size_t i = 0; i < count; i += 8) {
    Lanes x = load(counters_.data() + i, blocks_.data() + i, salt_);
    Lanes y = load(counters_.data() + i + 4, blocks_.data() + i + 4, salt_);
    auto key0 = static_cast<uint32_t>(system_key_), key1 = static_cast<uint32_t>(system_key_ >> 32);
    for (int r = 0; r < 10; ++r) {
      round(x, broadcast(key0), broadcast(key1));
      round(y, broadcast(key0), broadcast(key1));
      key0 += 0x9E3779B9;
      key1 += 0xBB67AE85;
    }
    store(x, numbers_.data() + 2 * i);
    store(y, numbers_.data() + 2 * i + 8);
  }
  return numbers_.data();
}

}  // namespace vug::lsystem
