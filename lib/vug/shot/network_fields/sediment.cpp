// SPDX-License-Identifier: Apache-2.0
// Mud, sand or gravel on the floors of passages.
#include <vug/passages/water/water_body.h>
#include <vug/shot/passage_params.h>

namespace vug::shot {
namespace {

struct Sediment : PassageParams {
  double depth = 0.3;
  double fill = 0;
  double repose = passages::SedimentOptions().repose;
  double overlap = passages::kOverlap;

  static void describe(Schema<Sediment>& s) {
    s.doc(
        "Mud, sand or gravel that fills the lower part of the passages of a network to a surface "
        "that is level across. Passages steeper than the angle of repose have none.");
    describe_network(s);
    describe_bed(s, "depth", "fill");
    s.param("repose", &Sediment::repose,
            {.doc = "steepest floor with sediment, which thins out 10 degrees below it",
             .dimension = Dimension::angle,
             .min = 0.05,
             .max = kPi / 2});
    describe_overlap(s, "sediment");
    describe_walls(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(sediment) {
  return field::field_kind<Sediment>("sediment", "passage", [](const Sediment& p) {
    return passages::sediment_body(
        *p.of, p.options(), {.depth = p.depth, .fill = p.fill, .repose = p.repose}, p.overlap);
  });
}
