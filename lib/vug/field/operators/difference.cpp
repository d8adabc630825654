// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Difference {
  Field base;
  std::vector<Field> cuts;
  Blend blend;

  static void describe(Schema<Difference>& s) {
    s.doc("The base without any of the cuts.")
        .cite("zawadzki2012")
        .param("base", &Difference::base, {.doc = "the solid to cut", .required = true})
        .param("cuts", &Difference::cuts, {.doc = "the solids to remove", .required = true})
        .param("blend", &Difference::blend, {.doc = "blend at the edge of a cut"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(difference) {
  return field_kind<Difference>("difference", "operator", [](const Difference& d) {
    return subtract(d.base, d.cuts, d.blend);
  });
}
