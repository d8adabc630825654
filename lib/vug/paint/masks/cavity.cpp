// SPDX-License-Identifier: Apache-2.0
// Concave regions of the painted solid, where more than half of the surrounding ball is solid.
#include <vug/paint/kind.h>
#include <vug/paint/solid_fraction.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Cavity {
  double radius = 0.1;

  static void describe(Schema<Cavity>& s) {
    s.doc("0 on flat and convex rock, 1 in right-angled hollows, inner corners and cracks.")
        .cite("pottmann2007")
        .param("radius", &Cavity::radius,
               positive_length("size of the hollows; at least two voxels"));
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(cavity) {
  return mask_kind<Cavity>("cavity", [](const Cavity& c) {
    return make_mask([c](const EvalPoint& point) {
      return std::clamp(4 * solid_fraction(point, c.radius) - 2, 0.0, 1.0);
    });
  });
}
