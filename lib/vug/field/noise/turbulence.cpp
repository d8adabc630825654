// SPDX-License-Identifier: Apache-2.0
#include <vug/field/octaves.h>

namespace vug::field {
namespace {

struct Turbulence : OctaveParams {
  static void describe(Schema<Turbulence>& s) {
    describe_octaves(
        s.doc("Folded noise that only displaces outwards: 0 along creases, larger between them.")
            .cite("perlin1985"));
  }
  void add_to(Digester& digester) const { digester(static_cast<const OctaveParams&>(*this)); }
};

/// 2 |n|.
struct TurbulenceShape {
  static constexpr double kSlope = 2;
  template <class T>
  static T of(const T& n) {
    return abs(n) * T(2.0);
  }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(turbulence) {
  return noise_kind<Turbulence>("turbulence",
                                [](const Turbulence& p) { return Fractal<TurbulenceShape>(p); });
}
