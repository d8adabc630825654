// SPDX-License-Identifier: Apache-2.0
// Standing water in the basins of the floors of passages.
#include <vug/passages/water/water_body.h>
#include <vug/shot/passage_params.h>

namespace vug::shot {
namespace {

struct Ponds : PassageParams {
  std::vector<std::string> to;
  double most = 1;
  double depth = 0;
  double fill = 0;
  double overlap = passages::kOverlap;

  static void describe(Schema<Ponds>& s) {
    s.doc(
         "Standing water in the passages of a network: each basin is full up to the height at "
         "which it spills, or up to a depth.")
        .cite("barnes2014");
    describe_network(s);
    s.param("to", &Ponds::to,
            {.doc = "stations where water leaves; by default all springs, or the lowest end"})
        .param("depth", &Ponds::most, positive_length("at the deepest point, at most"));
    describe_bed(s, "sediment", "fill");
    describe_overlap(s, "water");
    describe_walls(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(ponds) {
  return field::field_kind<Ponds>("ponds", "passage", [](const Ponds& p) {
    return passages::pond_body(*p.of, p.options(), {.depth = p.depth, .fill = p.fill},
                               stations_named(*p.of, p.to), p.most, p.overlap);
  });
}
