// SPDX-License-Identifier: Apache-2.0
#include <vug/field/noise.h>
#include <vug/paint/kind.h>
#include <vug/paint/space.h>

namespace vug::paint {
namespace {

struct NoiseMask : InSpace {
  field::Noise noise;
  double from = -0.5;
  double to = 0.5;

  static void describe(Schema<NoiseMask>& s) {
    s.doc(
         "0 at one value of a noise in space, 1 at another: stains, beds of another colour, "
         "patches.")
        .param("noise", &NoiseMask::noise, {.doc = "fbm, beds, worley, ...; about -1 to 1"})
        .param("from", &NoiseMask::from, {.doc = "value of the noise where the mask is 0"})
        .param("to", &NoiseMask::to, {.doc = "value where the mask is 1"});
    describe_space(s);
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(noise) {
  return mask_kind<NoiseMask>("noise", [](const NoiseMask& n) {
    const auto evaluate = [n](const EvalPoint& point) {
      return ramp(n.noise.field.value(point.position), n.from, n.to);
    };
    return make_mask(in_space(n, evaluate), n.uses());
  });
}
