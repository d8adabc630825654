// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct SymmetricDifference {
  Field a;
  Field b;
  Blend blend;

  static void describe(Schema<SymmetricDifference>& s) {
    s.doc("The region inside exactly one of two solids.")
        .param("a", &SymmetricDifference::a, {.doc = "one solid", .required = true})
        .param("b", &SymmetricDifference::b, {.doc = "the other", .required = true})
        .param("blend", &SymmetricDifference::blend, {.doc = "blend where the parts meet"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(symmetric_difference) {
  return field_kind<SymmetricDifference>(
      "symmetric_difference", "operator",
      [](const SymmetricDifference& d) { return symmetric_difference(d.a, d.b, d.blend); });
}
