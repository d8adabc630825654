// SPDX-License-Identifier: Apache-2.0
// Drips where water seeps out of the joints and pores of the rock.
#include <vug/shot/drips_plan.h>

namespace vug::shot {
namespace {

struct Seepage : DripParams {
  static void describe(Schema<Seepage>& s) {
    s.doc(
        "The drips of a cave: where water leaves joints and pores, how it runs, drops, lands and "
        "ponds, and the sizes of the speleothems that grow from it.");
    describe_drips(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_DRIPS_KIND(seepage) {
  return make_kind<DripsPtr, Seepage>("seepage", "drips", [](const Seepage& p) -> DripsPtr {
    return std::make_shared<const DripsPlan>(p);
  });
}
