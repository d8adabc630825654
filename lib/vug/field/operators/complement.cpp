// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Complement {
  Field field;

  static void describe(Schema<Complement>& s) {
    s.doc("Exchanges rock and air.")
        .param("field", &Complement::field, {.doc = "the solid to invert", .required = true});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(complement) {
  return field_kind<Complement>("complement", "operator",
                                [](const Complement& c) { return complement(c.field); });
}
