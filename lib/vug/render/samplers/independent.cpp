// SPDX-License-Identifier: Apache-2.0
// Independent uniform random numbers: the reference for other samplers.
#include <vug/base/rng.h>
#include <vug/render/kind.h>

namespace vug::render {
namespace {

struct Independent {
  static void describe(Schema<Independent>& s) {
    s.doc("Independent uniform random numbers; slowest convergence, but no patterns.")
        .cite("salmon2011philox");
  }
};

class IndependentSampler final : public Sampler {
 public:
  explicit IndependentSampler(const Independent&) {}

  Vec2f pair(const SampleId& id, uint32_t dimension) const override {
    const auto bits =
        philox4x32({id.x, id.y, id.index, dimension},
                   {static_cast<uint32_t>(id.seed), static_cast<uint32_t>(id.seed >> 32)});
    return {static_cast<float>(bits[0] >> 8) * 0x1p-24f,
            static_cast<float>(bits[1] >> 8) * 0x1p-24f};
  }
};

}  // namespace
}  // namespace vug::render

VUG_RENDER_KIND(independent, sampler, SamplerPtr, Independent, IndependentSampler)
