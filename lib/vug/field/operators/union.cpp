// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Union {
  std::vector<Field> of;
  Blend blend;

  static void describe(Schema<Union>& s) {
    s.doc("All solids together: the minimum of their values.")
        .cite("zawadzki2012")
        .param("of", &Union::of, {.doc = "the solids", .required = true})
        .param("blend", &Union::blend, {.doc = "blend where the solids meet"});
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(union) {
  return field_kind<Union>("union", "operator",
                           [](const Union& u) { return unite(u.of, u.blend); });
}
