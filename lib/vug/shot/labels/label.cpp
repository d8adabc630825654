// SPDX-License-Identifier: Apache-2.0
// The label of the part of a mesh that is nearest to a solid.
#include <vug/shot/labels.h>

namespace vug::shot {
namespace {

struct Label {
  std::string name;
  field::Field field;

  static void describe(Schema<Label>& s) {
    s.doc(
         "A label for the entry `labels` of a mesh: the attribute NAME is 1 at the vertices where "
         "the value of the field is below those of all other labels, and 0 elsewhere. The AOV "
         "CryptoElement has the name there.")
        .param("name", &Label::name, {.doc = "the name", .required = true})
        .param("field", &Label::field,
               {.doc = "the solid, e.g. centreline(of: part(of: plan, name: \"choke2\"))",
                .required = true});
  }
  std::string fault() const { return name.empty() ? "the name of a label must not be empty" : ""; }
};

}  // namespace
}  // namespace vug::shot

VUG_LABEL_KIND(label) {
  return make_kind<SurfaceLabel, Label>("label", "label", [](const Label& p) {
    return SurfaceLabel{p.name, p.field};
  });
}
