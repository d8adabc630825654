// SPDX-License-Identifier: Apache-2.0
// The distance to the axes of the passages of a network.
#include <vug/passages/lines/centreline.h>
#include <vug/shot/passage_line.h>

namespace vug::shot {
namespace {

struct Centreline : PassageLine {
  double radius = 0;

  static void describe(Schema<Centreline>& s) {
    s.doc(
        "The distance to the axes of the passages of a network, e.g. for masks, or tubes of one "
        "radius about them. The axes are those of passages(...) with the same parameters.");
    describe_network(s);
    describe_axes(s);
    s.param("radius", &Centreline::radius,
            {.doc = "radius of the tubes", .dimension = Dimension::length, .min = 0});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(centreline) {
  return field::field_kind<Centreline>("centreline", "passage", [](const Centreline& p) {
    return passages::centreline(passages::axis_lines(*p.of, p.options()), p.radius);
  });
}
