// SPDX-License-Identifier: Apache-2.0
#include <vug/field/boolean.h>
#include <vug/field/kind.h>

namespace vug::field {
namespace {

struct Intersection {
  std::vector<Field> of;
  Blend blend;

  static void describe(Schema<Intersection>& s) {
    s.doc("The common part of the solids: the maximum of their values.")
        .cite("zawadzki2012")
        .param("of", &Intersection::of, {.doc = "the solids, at least one", .required = true})
        .param("blend", &Intersection::blend, {.doc = "blend at the edge where the solids meet"});
  }
  std::string fault() const { return of.empty() ? "an intersection needs at least one solid" : ""; }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(intersection) {
  return field_kind<Intersection>("intersection", "operator",
                                  [](const Intersection& i) { return intersect(i.of, i.blend); });
}
