// SPDX-License-Identifier: Apache-2.0
#include <vug/field/kind.h>
#include <vug/field/speleothems/rimstone_params.h>

namespace vug::field {
namespace {

struct RimstoneWater : RimstoneParams {
  static void describe(Schema<RimstoneWater>& s) {
    s.doc(
         "The water of the pools of `rimstone` with the same parameters: it stands up to the lips "
         "and continues inside the stone.")
        .cite("hammer2010");
    describe_rimstone(s);
  }
};

}  // namespace
}  // namespace vug::field

VUG_FIELD_KIND(rimstone_water) {
  return field_kind<RimstoneWater>("rimstone_water", "detail",
                                   [](const RimstoneWater& p) { return rimstone_water(p); });
}
