#include <vug/field/displace.h>

namespace vug::field {
namespace {

struct Displace : Displacement {
  Field field;
  Noise noise;

  static void describe(Schema<Displace>& s) {
    s.doc(
         "Moves a surface out and in by a noise. The amount may differ where the solid faces up, "
         "sideways and down, and where another noise says so.")
        .cite("cook1984")
        .param("field", &Displace::field, {.doc = "whose surface moves", .required = true})
        .param("noise", &Displace::noise, {.doc = "how; 1 moves it outwards by the amount"})
        .param("amount", &Displacement::amount,
               any_length("at noise 1; noises reach a little beyond"))
        .param("floor", &Displacement::floor,
               {.doc = "factor on the amount where the solid faces up", .min = 0, .max = 100})
        .param("wall", &Displacement::wall,
               {.doc = "factor where it faces sideways", .min = 0, .max = 100})
        .param("ceiling", &Displacement::ceiling,
               {.doc = "factor where it faces down", .min = 0, .max = 100})
        .param("feel", &Displacement::feel, positive_length("over which the way it faces is felt"))
        .param("by", &Displacement::by,
               {.doc = "a noise that shares it out: all where 1, nothing where -1"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(displace) {
  return field_kind<Displace>("displace", "detail",
                              [](const Displace& d) { return displaced(d.field, d.noise, d); });
}
