// SPDX-License-Identifier: Apache-2.0
// A part of a network: the legs of a survey, a zone or a tier.
#include <vug/network/part.h>
#include <vug/shot/networks.h>
#include <vug/shot/stage_choice.h>

namespace vug::shot {
namespace {

struct Part {
  NetworkPtr of;
  std::string name;
  StageChoice stage = StageChoice::any;
  std::optional<int> tier;
  bool rest = false;

  static void describe(Schema<Part>& s) {
    s.doc(
         "A part of a network: the legs that fulfil all conditions. The stations keep their names "
         "and places.")
        .param("of", &Part::of, {.doc = "the network", .required = true})
        .param(
            "name", &Part::name,
            {.doc = "only legs of this survey and the surveys in it: \"choke2\" selects the legs "
                    "of dow.choke2 and dow.choke2.inlet; legs without a survey are selected by "
                    "the names of both stations"});
    describe_stage(s);
    s.param("tier", &Part::tier,
            {.doc = "only legs of this water table; 0 is the present one", .min = 0})
        .param("rest", &Part::rest, {.doc = "the legs that do not fulfil the conditions instead"});
  }
};

}  // namespace
}  // namespace vug::shot

VUG_NETWORK_KIND(part) {
  return make_kind<NetworkPtr, Part>("part", "network", [](const Part& p) -> NetworkPtr {
    return std::make_shared<const network::Network>(network::part_of(
        *p.of, {.name = p.name, .stage = stage_of(p.stage), .tier = p.tier, .rest = p.rest}));
  });
}
