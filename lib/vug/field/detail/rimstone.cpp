// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/field/speleothems/rimstone_params.h>

namespace vug::field {
namespace {

struct Rimstone : RimstoneParams {
  static void describe(Schema<Rimstone>& s) {
    s.doc(
         "Rimstone dams on the sloping floors of a rock: the crest of each pool is level, and the "
         "pools follow each other like stairs.")
        .cite("hammer2010");
    describe_rimstone(s);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(rimstone) {
  return field_kind<Rimstone>("rimstone", "detail", [](const Rimstone& p) { return rimstone(p); });
}
