// SPDX-License-Identifier: Apache-2.0
// Flutes of vertical shafts: half-pipes that films of falling water dissolve, side by side.
#include <vug/base/rng.h>
#include <vug/field/speleogens/plan_pits.h>

namespace vug::field {
namespace {

struct ShaftFlutes {
  double width = 0.5;
  Vec3d axis{0, 1, 0};
  int seed = 1;

  static void describe(Schema<ShaftFlutes>& s) {
    s.doc(
         "Half-pipes down the walls of a shaft, which meet in sharp ribs: about -1 at their "
         "deepest points, ribs near 0. Real ones are a fifth as deep as wide: use an amount of "
         "width / 5.")
        .param("width", &ShaftFlutes::width,
               positive_length("mean width of a flute, 10 cm to 60 cm in caves"))
        .param("axis", &ShaftFlutes::axis,
               {.doc = "direction of the flutes, of any length but 0; water falls along y"})
        .param("seed", &ShaftFlutes::seed,
               {.doc = "random seed; each seed gives different flutes"});
  }
  std::string fault() const { return axis.length2() > 0 ? "" : "the axis must not be zero"; }
};

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(shaft_flutes) {
  return noise_kind<ShaftFlutes>("shaft_flutes", [](const ShaftFlutes& s) {
    RandomStream random(RandomKey(static_cast<uint64_t>(s.seed)).at("shaft_flutes"));
    return PlanPits(s.width, s.axis, random.bits());
  });
}
