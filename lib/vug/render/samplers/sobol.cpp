// SPDX-License-Identifier: Apache-2.0
// Owen-scrambled Sobol points: one (0,2)-sequence along a Morton curve over the whole picture, so
// that neighbouring pixels have errors of opposite sign (blue noise).
//
// Sources: Ahmed and Wonka 2020, "Screen-space blue-noise diffusion of Monte Carlo sampling error
// via hierarchical ordering of pixels" (ahmed2020blue); Burley 2020, "Practical hash-based Owen
// scrambling" (burley2020owen); the hash is Vegdahl's 2021 variant of Laine and Karras'
// (vegdahl2021hash). Unlike Ahmed and Wonka we shuffle the binary tree of the index instead of its
// base-4 tree: 8 of 24 orders of each quad occur, at a fraction of the cost.
#include <vug/render/kind.h>

#include <immintrin.h>

namespace vug::render {
namespace {

struct Sobol {
  static void describe(Schema<Sobol>& s) {
    s.doc("Owen-scrambled Sobol points with blue-noise error over the picture.")
        .cite("ahmed2020blue");
  }
};

// Vectors of four dimensions; all lanes take the same steps.
using Lanes32 = uint32_t __attribute__((vector_size(16)));
using Lanes64 = uint64_t __attribute__((vector_size(32)));

// For a 32-bit number, or for each lane.
template <class V>
V reverse_bits(V v) {
  v = (v >> 16) | (v << 16);
  v = ((v >> 8) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8);
  v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
  v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
  return ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
}

/// A permutation in which each bit depends only on lower ones: on reversed bits, an Owen
/// scrambling.
template <class V>
V scramble_upwards(V v, V seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

/// The second Sobol dimension of index v, with its bits reversed: v times the Pascal matrix modulo
/// 2. This is a Kronecker power, so five steps suffice (ahmed2024sobol).
template <class V>
V times_pascal(V v) {
  v ^= (v >> 1) & 0x55555555u;
  v ^= (v >> 2) & 0x33333333u;
  v ^= (v >> 4) & 0x0f0f0f0fu;
  v ^= (v >> 8) & 0x00ff00ffu;
  return v ^ (v >> 16);
}

/// Interleaves the bits of x and y: the index on the Morton curve.
uint64_t interleaved(uint32_t x, uint32_t y) {
  return _pdep_u64(x, 0x5555555555555555ull) | _pdep_u64(y, 0xaaaaaaaaaaaaaaaaull);
}

template <class V>
V mix(V v) {  // finaliser of SplitMix64 (Steele et al. 2014)
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

float to_unit(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

class SobolSampler final : public Sampler {
 public:
  explicit SobolSampler(const Sobol&) {}

  Vec2f pair(const SampleId& id, uint32_t dimension) const override {
    const auto [low, high] = locate(id);
    const uint64_t a = mix(key(id, high) + kStep * (dimension + 1)), b = mix(a + kStep);
    const auto seed_x = static_cast<uint32_t>(b), seed_y = static_cast<uint32_t>(b >> 32);
    const uint32_t index = shuffled(low, static_cast<uint32_t>(a));
    return {to_unit(reverse_bits(scramble_upwards(index, seed_x))),
            to_unit(reverse_bits(scramble_upwards(times_pascal(index), seed_y)))};
  }
  FourPairs four_pairs(const SampleId& id, uint32_t dimension) const override {
    const auto [low, high] = locate(id);
    const Lanes64 dimensions = Lanes64{1, 2, 3, 4} + uint64_t{dimension};
    const Lanes64 a = mix(key(id, high) + kStep * dimensions), b = mix(a + kStep);
    const auto seed_x = __builtin_convertvector(b, Lanes32);
    const auto seed_y = __builtin_convertvector(b >> 32, Lanes32);
    const Lanes32 index =
        shuffled(Lanes32{low, low, low, low}, __builtin_convertvector(a, Lanes32));
    const Lanes32 x = reverse_bits(scramble_upwards(index, seed_x));
    const Lanes32 y = reverse_bits(scramble_upwards(times_pascal(index), seed_y));
    FourPairs out;
    for (size_t i = 0; i < out.size(); ++i) out[i] = {to_unit(x[i]), to_unit(y[i])};
    return out;
  }

 private:
  static constexpr uint64_t kStep = 0x9e3779b97f4a7c15ull;

  /// The sample's index in the sequence. A pixel owns an aligned block of 2^k >= spp indices, so
  /// its points are a (0,k,2)-net.
  static std::pair<uint32_t, uint32_t> locate(const SampleId& id) {
    const int bits = id.spp > 1 ? 32 - __builtin_clz(id.spp - 1) : 0;
    const uint64_t along = (interleaved(id.x, id.y) << bits) | id.index;
    return {static_cast<uint32_t>(along), static_cast<uint32_t>(along >> 32)};
  }
  /// Index bits above 32 become part of the seed.
  static uint64_t key(const SampleId& id, uint32_t high) {
    return id.seed + high * 0xd1342543de82ef95ull;
  }
  /// Each dimension pair visits the same points in a different order.
  template <class V>
  static V shuffled(V index, V seed) {
    return reverse_bits(scramble_upwards(reverse_bits(index), seed));
  }
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sobol, sampler, SamplerPtr, Sobol, SobolSampler)
