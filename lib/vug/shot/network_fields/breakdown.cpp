// SPDX-License-Identifier: Apache-2.0
// The pile of blocks that fell from a vault.
#include <vug/passages/breakdown/pile.h>
#include <vug/shot/networks.h>
#include <vug/shot/vault_params.h>

namespace vug::shot {
namespace {

struct Breakdown : VaultParams {
  double floor = 0;
  double repose = passages::PileOptions().repose;
  double bulk = passages::PileOptions().bulk;
  double broken = passages::PileOptions().broken;
  double fines = 0.8;

  static void describe(Schema<Breakdown>& s) {
    s.doc(
         "The blocks that fell from the `vault` with the same parameters, at rest on a pile. They "
         "touch and do not overlap.")
        .cite("white1969breakdown");
    describe_vault(s);
    s.param("floor", &Breakdown::floor, any_length("height of the ground"))
        .param("repose", &Breakdown::repose,
               {.doc = "slope of the pile", .dimension = Dimension::angle, .min = 0.1, .max = 1.2})
        .param("bulk", &Breakdown::bulk,
               {.doc = "volume of the pile with its gaps, by that of the vault",
                .min = 1.05,
                .max = 3})
        .param(
            "broken", &Breakdown::broken,
            {.doc = "depth of the breaks of edges and corners; 0: sharp boxes", .min = 0, .max = 1})
        .param("fines", &Breakdown::fines,
               {.doc = "height of the fine rubble between the blocks, by that of the pile; 0: none",
                .min = 0,
                .max = 1});
  }
};

field::Field blocks(const Breakdown& p) {
  return passages::breakdown_body(p.vault(),
                                  {.floor = p.floor,
                                   .repose = p.repose,
                                   .bulk = p.bulk,
                                   .broken = p.broken,
                                   .seed = static_cast<uint64_t>(p.seed)},
                                  p.fines);
}

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_FIELD_KIND(breakdown) {
  return field::field_kind<Breakdown>("breakdown", "passage", blocks);
}
