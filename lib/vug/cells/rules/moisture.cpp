// SPDX-License-Identifier: Apache-2.0
#include <vug/cells/diffusion.h>
#include <vug/cells/rule.h>

namespace vug::cells {
namespace {

/// The flow between two cells is equal for both, so moisture is conserved without drying. Where
/// diffusion D and evaporation k balance, moisture falls to 37% over sqrt(D / k), `reach`.
struct Moisture {
  double creep = 0.03;
  double reach = 0.15;
  std::string from = "water";
  double full = 0.3;

  static void describe(Schema<Moisture>& s) {
    s.doc(
         "Rock is saturated (moisture: 1) where water runs; from there moisture creeps into the "
         "surrounding rock and dries, faster in open places (exposure, if a recipe provides it).")
        .cite("hall2002")
        .param("reach", &Moisture::reach,
               positive_length("distance from the wet area over which moisture falls to 37%"));
    describe_diffusion(s);
  }

  void step(Pass& pass) const {
    const Network& network = pass.network();
    const DiffusionSteps seep(creep, network.spacing);
    const auto given = static_cast<float>(seep.share / network.full);
    const double steps = network.spacing / (2 * reach);
    const auto dries = static_cast<float>(std::min(seep.share * steps * steps, 1 - seep.share));
    const OptionalReader water = pass.reads_optional(from, 0),
                         open = pass.reads_optional("exposure", 1);
    const auto wets = static_cast<float>(1 / full);
    for (int round = 0; round < seep.rounds; ++round) {
      const auto m = pass.writes<float>("moisture");
      pass.run([=](const auto& neighbours, uint32_t i) {
        float sum = 0;
        const auto links = static_cast<float>(neighbours.each(i, [&](uint32_t n) { sum += m[n]; }));
        const float left = m[i] + given * (sum - links * m[i]) - dries * open[i] * m[i];
        m.set(i, std::max(left, std::min(1.0f, wets * water[i])));
      });
    }
  }
};

}  // namespace
}  // namespace vug::cells

VUG_RULE_KIND(moisture) { return rule_kind<Moisture>("moisture"); }
