// SPDX-License-Identifier: Apache-2.0
#include <vug/field/rock_material_kind.h>

namespace vug::field {
namespace {

struct RockMaterialParams : RockMaterial {
  static void describe(Schema<RockMaterialParams>& s) {
    s.doc(
         "A material of rock, sediment or dripstone, for made_of, host_rock and coat. A text is a "
         "material of hardness 0.")
        .param("name", &RockMaterial::name,
               {.doc = "the name: letters, digits and \"_\"", .required = true})
        .param("hardness", &RockMaterial::hardness,
               {.doc = "resistance to water and frost, from 0 to 1; see the noise hardness",
                .dimension = Dimension::ratio,
                .min = 0,
                .max = 1});
  }
  std::string fault() const { return name_fault(*this); }
};

}  // namespace
}  // namespace vug::field

VUG_ROCK_MATERIAL_KIND(rock_material) {
  return make_kind<RockMaterialPtr, RockMaterialParams>(
      "rock_material", "rock material",
      [](const RockMaterialParams& p) { return std::make_shared<const RockMaterial>(p); });
}
