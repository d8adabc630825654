// SPDX-License-Identifier: Apache-2.0
// Convex edges of the painted solid, which weather first: less than half of the surrounding ball is
// solid.
#include <vug/paint/kind.h>
#include <vug/paint/solid_fraction.h>

#include <algorithm>

namespace vug::paint {
namespace {

struct Edge {
  double radius = 0.1;

  static void describe(Schema<Edge>& s) {
    s.doc("0 on flat and concave rock, 1 on right-angled edges, corners and spikes.")
        .cite("pottmann2007")
        .param("radius", &Edge::radius, positive_length("size of the edges; at least two voxels"));
  }
};

}  // namespace
}  // namespace vug::paint

VUG_MASK_KIND(edge) {
  return mask_kind<Edge>("edge", [](const Edge& e) {
    return make_mask([e](const EvalPoint& point) {
      return std::clamp(2 - 4 * solid_fraction(point, e.radius), 0.0, 1.0);
    });
  });
}
