// SPDX-License-Identifier: Apache-2.0
#include <vug/field/displace.h>

namespace vug::field {
namespace {

struct Displace : Displacement {
  Field field;
  Noise noise;

  static void describe(Schema<Displace>& s) {
    s.doc(
         "Displaces a surface by a noise. The amount may differ where the solid faces up, sideways "
         "and down, and may be masked by another noise.")
        .cite("cook1984")
        .param("field", &Displace::field,
               {.doc = "the solid whose surface moves", .required = true})
        .param("noise", &Displace::noise,
               {.doc = "the displacement; 1 moves the surface outwards by the amount"})
        .param("amount", &Displacement::amount,
               any_length("displacement at noise 1; noises slightly exceed 1"))
        .param("floor", &Displacement::floor,
               {.doc = "factor on the amount where the solid faces up", .min = 0, .max = 100})
        .param("wall", &Displacement::wall,
               {.doc = "factor where it faces sideways", .min = 0, .max = 100})
        .param("ceiling", &Displacement::ceiling,
               {.doc = "factor where it faces down", .min = 0, .max = 100})
        .param("feel", &Displacement::feel,
               positive_length("distance over which the slope of the surface is measured"))
        .param("by", &Displacement::by,
               {.doc = "a noise as mask: full displacement at 1, none at -1"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(displace) {
  return field_kind<Displace>("displace", "detail",
                              [](const Displace& d) { return displaced(d.field, d.noise, d); });
}
