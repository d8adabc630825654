// SPDX-License-Identifier: Apache-2.0
// Shelfstone: calcite that grows from the shore of a pool along the surface of its water.
#include <vug/base/rng.h>
#include <vug/field/grown_material.h>
#include <vug/field/speleothems/ledge.h>

namespace vug::field {
namespace {

struct Shelfstone {
  Field field;
  std::vector<double> levels{0};
  double width = 0.12;
  double wander = 0.6;
  double reach = 0.4;
  double thickness = 0.03;
  double rim = 0.008;
  int seed = 1;
  RockMaterialPtr material{};

  static void describe(Schema<Shelfstone>& s) {
    s.doc(
         "Shelfstone: ledges with flat tops, exactly at the levels of the water in which they "
         "grew. They are thick at the wall and thin at the rim.")
        .param("field", &Shelfstone::field, {.doc = "the rock", .required = true})
        .param("levels", &Shelfstone::levels,
               {.doc = "heights of the surfaces of the water", .dimension = Dimension::length})
        .param("width", &Shelfstone::width,
               positive_length("mean width of a ledge, 1 to 30 cm in caves; measured as the "
                               "distance from the rock"))
        .param("wander", &Shelfstone::wander,
               {.doc = "variation of the width along the shore; 0 is even",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1})
        .param("reach", &Shelfstone::reach, positive_length("wavelength of the variation"))
        .param("thickness", &Shelfstone::thickness,
               positive_length("thickness of a ledge at the wall"))
        .param("rim", &Shelfstone::rim,
               positive_length("thickness of its rim; in a level set at least two voxels"))
        .param("seed", &Shelfstone::seed,
               {.doc = "random seed; each seed gives another variation"});
    describe_growth_material(s);
  }
  std::string fault() const {
    if (levels.empty()) return "shelfstone needs at least one level";
    if (rim > thickness) return "the rim of shelfstone must be at most as thick as its root";
    return growth_fault(field, material);
  }
  Ledge ledge() const {
    return {levels,
            width,
            wander,
            thickness,
            rim,
            Vec3d(1 / reach, 0, 0),
            Vec3d(0, 0, 1 / reach),
            RandomStream(RandomKey(static_cast<uint64_t>(seed)).at("shelfstone")).bits()};
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(shelfstone) {
  return field_kind<Shelfstone>("shelfstone", "detail", [](const Shelfstone& s) {
    const Field ledges(
        std::make_shared<ModifierNode<Ledge>>("shelfstone", s.ledge(), s.field.node()));
    return grown_on(s.field, ledges, s.material);
  });
}
