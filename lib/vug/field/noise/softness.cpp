// SPDX-License-Identifier: Apache-2.0
// 2 (1 - H)^g - 1 with the hardness H of each material, mixed by their weights. As the mask of a
// displacement its factor is (1 - H)^g. Inside a contact this is the mean of the factors of both
// materials, not the factor of their mean hardness.
#include <vug/base/maths.h>
#include <vug/field/material_source.h>
#include <vug/field/noise.h>

namespace vug::field {
namespace {

struct Softness {
  Field of;
  double contact = 0.3;
  double exponent = 1;

  static void describe(Schema<Softness>& s) {
    s.doc(
         "1 where the materials of a rock have hardness 0, -1 where they have hardness 1: as the "
         "mask of displace or strata it makes soft beds recede and hard ones stay.")
        .param("of", &Softness::of,
               {.doc = "a solid with materials, e.g. host_rock(...)", .required = true})
        .param("contact", &Softness::contact,
               positive_length("width over which it changes at contacts; the narrower, the steeper "
                               "is a displaced surface there"))
        .param("exponent", &Softness::exponent,
               {.doc = "the displacement has the factor (1 - hardness)^exponent",
                .min = 0.1,
                .max = 10});
  }
  std::string fault() const {
    return materials_of(of).empty()
               ? "'of' has no materials: assign them with made_of(...) or host_rock(...)"
               : "";
  }
};

Noise noise_of(const Softness& s) {
  MaterialNumber number;
  number.number = [exponent = s.exponent](const RockMaterial& material) {
    return 2 * maths::pow(1 - material.hardness, exponent) - 1;
  };
  number.range = {-1, 1};
  number.contact = s.contact;
  return Noise(material_mean(s.of, number).value(), number.range);
}

}  // namespace
}  // namespace vug::field

VUG_NOISE_KIND(softness) { return make_kind<Noise, Softness>("softness", "noise", noise_of); }
