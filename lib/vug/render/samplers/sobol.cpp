// Owen-scrambled Sobol points, one (0,2)-sequence laid over the whole picture along a Morton
// curve, so that neighbouring pixels err in opposite directions (blue noise).
//
// Sources: Ahmed and Wonka 2020, "Screen-space blue-noise diffusion of Monte Carlo sampling
// error via hierarchical ordering of pixels" (ahmed2020blue); Burley 2020, "Practical hash-based
// Owen scrambling" (burley2020owen); the hash is Vegdahl's 2021 variant of Laine and Karras'
// (vegdahl2021hash). We differ from Ahmed and Wonka in shuffling the binary tree of the index
// instead of its base-4 tree: 8 of 24 orders of each quad occur, at a fraction of the cost.
#include <vug/render/kind.h>

#include <immintrin.h>

namespace vug::render {
namespace {

struct Sobol {
  static void describe(Schema<Sobol>& s) {
    s.doc("Owen-scrambled Sobol points whose error is blue noise over the picture.")
        .cite("ahmed2020blue");
  }
};

uint32_t reverse_bits(uint32_t v) {
  v = __builtin_bswap32(v);
  v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
  v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
  return ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
}

/// A permutation in which each bit depends only on lower ones: on reversed bits, an Owen
/// scrambling.
uint32_t scramble_upwards(uint32_t v, uint32_t seed) {
  v ^= v * 0x3d20adeau;
  v += seed;
  v *= (seed >> 16) | 1u;
  v ^= v * 0x05526c56u;
  v ^= v * 0x53a22864u;
  return v;
}

/// The second Sobol dimension of index v, bits reversed: v times the Pascal matrix modulo 2, which
/// is a Kronecker power, so five steps do it (ahmed2024sobol).
uint32_t times_pascal(uint32_t v) {
  v ^= (v >> 1) & 0x55555555u;
  v ^= (v >> 2) & 0x33333333u;
  v ^= (v >> 4) & 0x0f0f0f0fu;
  v ^= (v >> 8) & 0x00ff00ffu;
  return v ^ (v >> 16);
}

/// Bits of x and y in turn: the place on the Morton curve.
uint64_t interleaved(uint32_t x, uint32_t y) {
  return _pdep_u64(x, 0x5555555555555555ull) | _pdep_u64(y, 0xaaaaaaaaaaaaaaaaull);
}

uint64_t mix(uint64_t v) {  // finaliser of SplitMix64 (Steele et al. 2014)
  v = (v ^ (v >> 30)) * 0xbf58476d1ce4e5b9ull;
  v = (v ^ (v >> 27)) * 0x94d049bb133111ebull;
  return v ^ (v >> 31);
}

float to_unit(uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24f; }

class SobolSampler final : public Sampler {
 public:
  explicit SobolSampler(const Sobol&) {}

  Vec2f pair(const SampleId& id, uint32_t dimension) const override {
    const Place place = locate(id, dimension);
    return {to_unit(reverse_bits(scramble_upwards(place.index, place.seed_x))),
            to_unit(reverse_bits(scramble_upwards(times_pascal(place.index), place.seed_y)))};
  }
  float single(const SampleId& id, uint32_t dimension) const override {
    const Place place = locate(id, dimension);
    return to_unit(reverse_bits(scramble_upwards(place.index, place.seed_x)));
  }

 private:
  struct Place {
    uint32_t index, seed_x, seed_y;
  };

  /// Each dimension pair visits the same points in an order of its own. A pixel owns an aligned
  /// block of 2^k >= spp indices, so its points are a (0,k,2)-net. What exceeds 32 bits of index
  /// goes into the seed.
  static Place locate(const SampleId& id, uint32_t dimension) {
    const int bits = id.spp > 1 ? 32 - __builtin_clz(id.spp - 1) : 0;
    const uint64_t along = (interleaved(id.x, id.y) << bits) | id.index;
    const uint64_t a = mix(id.seed + 0x9e3779b97f4a7c15ull * (dimension + 1) +
                           (along >> 32) * 0xd1342543de82ef95ull);
    const uint64_t b = mix(a + 0x9e3779b97f4a7c15ull);
    const auto low = static_cast<uint32_t>(along);
    return {reverse_bits(scramble_upwards(reverse_bits(low), static_cast<uint32_t>(a))),
            static_cast<uint32_t>(b), static_cast<uint32_t>(b >> 32)};
  }
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(sobol, sampler, SamplerPtr, Sobol, SobolSampler)
