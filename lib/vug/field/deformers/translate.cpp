// SPDX-License-Identifier: Apache-2.0
#include <vug/field/affine.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Translate {
  Field field;
  Vec3d by{0, 0, 0};

  static void describe(Schema<Translate>& s) {
    s.doc("Moves a solid.")
        .param("field", &Translate::field, {.doc = "the solid to move", .required = true})
        .param("by", &Translate::by, any_length("displacement"));
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(translate) {
  return field_kind<Translate>("translate", "deformer", [](const Translate& t) {
    return transformed(t.field, vug::Transform::translation(t.by));
  });
}
