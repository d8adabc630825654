// SPDX-License-Identifier: Apache-2.0
#include <vug/field/blend_kind.h>

namespace vug::field {
namespace {

struct Chamfer {
  double radius = 0.2;

  static void describe(Schema<Chamfer>& s) {
    s.doc("A flat chamfer across the crease.")
        .param("radius", &Chamfer::radius, positive_length("leg length of the chamfer"));
  }
};

}  // namespace
}  // namespace vug::field

VUG_BLEND_KIND(chamfer) {
  return blend_kind<Chamfer>("chamfer", [](const Chamfer& b) {
    return Blend{Profile::chamfer, b.radius};
  });
}
