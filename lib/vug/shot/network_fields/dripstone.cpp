// SPDX-License-Identifier: Apache-2.0
// Rock with the speleothems of its drips.
#include <vug/shot/drips_plan.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

struct Dripstone : DripParams, SpeleothemJoin {
  static void describe(Schema<Dripstone>& s) {
    s.doc(
         "Rock with stalactites and straws at its drips, stalagmites vertically below them, "
         "columns where they have met, draperies along sloping roofs, and flowstone on walls and "
         "floors.")
        .cite("short2005");
    describe_drips(s);
    SpeleothemJoin::describe(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(dripstone) {
  return field::field_kind<Dripstone>("dripstone", "detail", [](const Dripstone& p) {
    return with_speleothems(std::make_shared<const DripsPlan>(p), p);
  });
}
