// SPDX-License-Identifier: Apache-2.0
// The rock of named drips with their speleothems.
#include <vug/shot/drips_plan.h>
#include <vug/shot/networks.h>

namespace vug::shot {
namespace {

struct Speleothems : SpeleothemJoin {
  DripsPtr of;
  SpeleothemPart part = SpeleothemPart::all;

  static void describe(Schema<Speleothems>& s) {
    s.doc("The rock of named drips with the speleothems that grow from them, as in dripstone(...).")
        .cite("short2005")
        .param("of", &Speleothems::of, {.doc = "the drips", .required = true})
        .choice(
            "part", &Speleothems::part,
            {{"all", SpeleothemPart::all},
             {"solids", SpeleothemPart::solids},
             {"rock", SpeleothemPart::rock}},
            "all, the solids alone, or the rock with its flowstone: two volumes may have voxels "
            "of different sizes");
    SpeleothemJoin::describe(s);
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(speleothems) {
  return field::field_kind<Speleothems>("speleothems", "detail", [](const Speleothems& p) {
    return with_speleothems(p.of, p, p.part);
  });
}
