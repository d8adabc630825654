// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Morph {
  Field a;
  Field b;
  double amount = 0.5;

  static void describe(Schema<Morph>& s) {
    s.doc("A solid between two others: the weighted mean of their values.")
        .cite("zawadzki2012")
        .param("a", &Morph::a, {.doc = "the solid at 0%", .required = true})
        .param("b", &Morph::b, {.doc = "the solid at 100%", .required = true})
        .param(
            "amount", &Morph::amount,
            {.doc = "position between a and b", .dimension = Dimension::ratio, .min = 0, .max = 1});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(morph) {
  return field_kind<Morph>("morph", "operator",
                           [](const Morph& m) { return morph(m.a, m.b, m.amount); });
}
