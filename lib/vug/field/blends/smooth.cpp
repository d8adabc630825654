// SPDX-License-Identifier: Apache-2.0
#include <vug/field/blend_kind.h>

namespace vug::field {
namespace {

struct Smooth {
  double radius = 0.2;

  static void describe(Schema<Smooth>& s) {
    s.doc("A soft fillet with a parabolic section.")
        .cite("quilez2013smin")
        .param("radius", &Smooth::radius,
               positive_length("operands blend where they differ by less than this"));
  }
};

}  // namespace
}  // namespace vug::field

VUG_BLEND_KIND(smooth) {
  return blend_kind<Smooth>("smooth", [](const Smooth& b) {
    return Blend{Profile::smooth, b.radius};
  });
}
