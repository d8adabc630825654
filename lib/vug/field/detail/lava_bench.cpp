// SPDX-License-Identifier: Apache-2.0
// Benches of a lava tube: crust that froze to the walls while the flow stood at a level, and stayed
// when the flow drained down.
#include <vug/base/rng.h>
#include <vug/field/speleogens/frame.h>
#include <vug/field/speleothems/ledge.h>

namespace vug::field {
namespace {

struct LavaBench {
  Field field;
  std::vector<double> levels{0};
  double width = 0.5;
  double thickness = 0.4;
  double lip = 0.25;
  Vec3d flow{1, 0, 0};
  double wander = 0.3;
  double reach = 6;
  int seed = 1;

  static void describe(Schema<LavaBench>& s) {
    s.doc(
         "Benches along both walls of a lava tube, with flat tops at the levels where the lava "
         "stood. Their rims follow the flow.")
        .param("field", &LavaBench::field, {.doc = "the rock", .required = true})
        .param("levels", &LavaBench::levels,
               {.doc = "heights of the tops of the benches", .dimension = Dimension::length})
        .param("width", &LavaBench::width, positive_length("mean width of a bench"))
        .param("thickness", &LavaBench::thickness, positive_length("thickness at the wall"))
        .param("lip", &LavaBench::lip, positive_length("thickness of the rim"))
        .param("flow", &LavaBench::flow, {.doc = "direction of the lava, of any length but 0"})
        .param("wander", &LavaBench::wander,
               {.doc = "variation of the width; 0 is even",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("reach", &LavaBench::reach,
               positive_length("wavelength of the variation along the flow"))
        .param("seed", &LavaBench::seed, {.doc = "random seed; each seed gives another variation"});
  }
  std::string fault() const {
    if (levels.empty()) return "benches need at least one level";
    if (!(flow.length2() > 0)) return "the direction of the lava must not be zero";
    return lip <= thickness ? "" : "the lip of a bench must be at most as thick as its root";
  }
  Ledge ledge() const {
    constexpr double kShorter = 3;  // Across the flow, so that the two walls differ.
    return {levels,
            width,
            wander,
            thickness,
            lip,
            flow.normalized() / reach,
            Across(flow).side * (kShorter / reach),
            RandomStream(RandomKey(static_cast<uint64_t>(seed)).at("lava_bench")).bits()};
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(lava_bench) {
  return field_kind<LavaBench>("lava_bench", "detail", [](const LavaBench& b) {
    return Field(std::make_shared<ModifierNode<Ledge>>("lava_bench", b.ledge(), b.field.node()));
  });
}
