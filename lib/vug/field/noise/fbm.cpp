// SPDX-License-Identifier: Apache-2.0
#include <vug/field/octaves.h>

namespace vug::field {
namespace {

struct Fbm : OctaveParams {
  static void describe(Schema<Fbm>& s) {
    describe_octaves(s.doc("Fractal Brownian motion: smooth features with ever finer ones added.")
                         .cite("musgrave1989"));
  }
  void add_to(Digester& digester) const { digester(static_cast<const OctaveParams&>(*this)); }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(fbm) {
  return noise_kind<Fbm>("fbm", [](const Fbm& p) { return Fractal<PlainShape>(p); });
}
