// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/factors.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Scale {
  Field field;
  Factors by;

  static void describe(Schema<Scale>& s) {
    s.doc(
         "Scales a solid, by one factor or by one along each axis; different factors give a lower "
         "bound of the distance.")
        .param("field", &Scale::field, {.doc = "the solid to scale", .required = true})
        .param(
            "by", &Scale::by,
            {.doc = "one factor, or one per axis", .min = 0, .above_min = true, .required = true});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(scale) {
  return field_kind<Scale>("scale", "deformer", [](const Scale& s) {
    return transformed(s.field, vug::Transform::scaling(s.by.each));
  });
}
